#include "iidc/config_rom.h"

#include <pcl/core/camera_exception.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>

namespace {

/** A quadlet of a camera's ROM, big-endian as on the bus. */
std::uint32_t
quadletAt(const std::uint8_t* data, std::size_t size, std::size_t index)
{
  if (4 * index + 3 >= size)
    throw pcl::CameraException(pcl::CameraFault::Unsupported, "nothing is there");
  std::uint32_t quadlet = 0;
  for (std::size_t i = 0; i < 4; ++i)
    quadlet = quadlet << 8 | data[4 * index + i];
  return quadlet;
}

} // namespace

/** A ROM is rejected, or identifies the camera; each quadlet is read at most once. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::set<std::size_t> seen;
  try {
    pcl::acmap::readConfigRom([&](std::size_t index) {
      if (index >= pcl::acmap::config_rom_quadlets || !seen.insert(index).second)
        std::abort();
      return quadletAt(data, size, index);
    });
  }
  catch (const pcl::CameraException&) {
  }
  return 0;
}
