#include "usb_control.h"

#include <algorithm>

namespace pcl::acmap::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t setup_size = 8;
constexpr std::uint8_t vendor_read = 0xC0;
constexpr std::uint8_t vendor_write = 0x40;
constexpr std::uint8_t registers_request = 0x7F;

unsigned
word(const std::uint8_t* bytes)
{
  return bytes[0] | bytes[1] << 8;
}

std::optional<Bytes>
readQuadlets(EmulatedIidcCamera& camera, std::uint64_t address, std::size_t length)
{
  Bytes bytes;
  for (; bytes.size() < length; address += 4) {
    const auto value = camera.read(address);
    if (!value)
      return std::nullopt;
    for (int shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<std::uint8_t>(*value >> shift));
  }
  return bytes;
}

std::optional<Bytes>
writeQuadlets(EmulatedIidcCamera& camera,
              std::uint64_t address,
              const std::uint8_t* data,
              std::size_t length)
{
  for (std::size_t i = 0; i < length; i += 4)
    if (!camera.write(address + i, word(data + i) | word(data + i + 2) << 16))
      return std::nullopt;
  return Bytes(data, data + length);
}

} // namespace

std::optional<std::vector<std::uint8_t>>
answerControl(EmulatedIidcCamera& camera,
              const UsbIdentity& identity,
              const std::uint8_t* message,
              std::size_t size)
{
  if (size < setup_size)
    return std::nullopt;
  const std::uint8_t type = message[0];
  const std::size_t length =
      std::min<std::size_t>(word(message + 6), size - setup_size);
  const bool string = type == 0x80 && message[1] == 6 && message[3] == 3;
  if (string) {
    Bytes text = stringDescriptor(identity, message[2]);
    if (text.empty())
      return std::nullopt;
    text.resize(std::min(text.size(), length));
    return text;
  }
  if (message[1] != registers_request || length % 4 != 0)
    return std::nullopt;
  const std::uint64_t address =
      0xFFFF00000000 | std::uint64_t{word(message + 4)} << 16 | word(message + 2);
  if (type == vendor_read)
    return readQuadlets(camera, address, length);
  if (type == vendor_write)
    return writeQuadlets(camera, address, message + setup_size, length);
  return std::nullopt;
}

} // namespace pcl::acmap::test
