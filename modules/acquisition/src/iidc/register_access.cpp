#include "register_access.h"

namespace pcl::acmap {

std::optional<std::uint32_t>
RegisterAccess::tryRead(std::uint64_t offset) const
{
  constexpr std::uint32_t nothing = 0xFFFFFFFF; // answer for missing registers
  try {
    const std::uint32_t value = read(offset);
    return value != nothing ? std::optional(value) : std::nullopt;
  }
  catch (const CameraException& exception) {
    if (exception.fault() == CameraFault::Unsupported)
      return std::nullopt;
    throw;
  }
}

std::optional<RegisterAccess>
RegisterAccess::behind(std::uint64_t offset) const
{
  const std::uint32_t quadlets = tryRead(offset).value_or(0);
  // The register space has 28 bits; the largest block of registers must fit into it.
  constexpr std::uint64_t maximum = (0x10000000 - iidc::scalable::bytes) / 4;
  if (quadlets == 0 || quadlets > maximum)
    return std::nullopt;
  return RegisterAccess(bus_, iidc::register_space + 4 * std::uint64_t{quadlets});
}

} // namespace pcl::acmap
