#include "config_rom.h"

#include "iidc_addresses.h"

namespace pcl::acmap::test {
namespace {

using Quadlets = std::vector<std::uint32_t>;

constexpr std::uint32_t
entry(std::uint32_t key, std::uint32_t value)
{
  return key << 24 | (value & 0xFFFFFF);
}

/** \brief Checksum of a block of the ROM: CRC-16 of ITU-T, as defined by IEEE 1212. */
std::uint32_t
checkOf(const Quadlets& block)
{
  std::uint32_t check = 0;
  for (const std::uint32_t quadlet : block)
    for (int shift = 28; shift >= 0; shift -= 4) {
      const std::uint32_t sum = ((check >> 12) ^ (quadlet >> shift)) & 0xF;
      check = (check << 4) ^ (sum << 12) ^ (sum << 5) ^ sum;
      check &= 0xFFFF;
    }
  return check;
}

void
append(Quadlets& rom, const Quadlets& block)
{
  rom.push_back(static_cast<std::uint32_t>(block.size()) << 16 | checkOf(block));
  rom.insert(rom.end(), block.begin(), block.end());
}

/** \brief A text with at least one terminating zero, the first character in the high
 * byte. */
Quadlets
leafOf(const std::string& text)
{
  Quadlets leaf(2 + text.size() / 4 + 1, 0);
  for (std::size_t i = 0; i < text.size(); ++i)
    leaf[2 + i / 4] |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]))
                       << (24 - 8 * (i % 4));
  return leaf;
}

} // namespace

std::vector<std::uint32_t>
configRomOf(const CameraIdentity& identity)
{
  const auto high = static_cast<std::uint32_t>(identity.guid >> 32);
  const Quadlets bus = {
      0x31333934, 0x20FF5003, high, static_cast<std::uint32_t>(identity.guid)};
  Quadlets rom = {0x04040000 | checkOf(bus)};
  rom.insert(rom.end(), bus.begin(), bus.end());

  // The offset in an entry is in quadlets, relative to the entry itself.
  append(rom, {entry(0x03, high >> 8), entry(0x0C, 0x0083C0), entry(0xD1, 1)});
  const std::uint32_t unit = identity.point_grey_unit ? 0x00B09D : 0x00A02D;
  append(rom, {entry(0x12, unit), entry(0x13, 0x000102), entry(0xD4, 1)});
  const Quadlets vendor = leafOf(identity.vendor);
  append(rom,
         {entry(0x40, iidc::command_base / 4),
          entry(0x81, 2),
          entry(0x82, static_cast<std::uint32_t>(vendor.size()) + 2)});
  append(rom, vendor);
  append(rom, leafOf(identity.model));
  return rom;
}

} // namespace pcl::acmap::test
