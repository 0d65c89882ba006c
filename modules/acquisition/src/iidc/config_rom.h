#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace pcl::acmap {

/** \brief Where a camera's configuration ROM begins, and how many quadlets it has at
 * most (IEEE 1212). */
constexpr std::uint64_t config_rom_address = 0xFFFFF0000400;
constexpr std::size_t config_rom_quadlets = 256;

/** \brief Who makes the rules that a camera's registers follow: key 0x12 of its unit. */
constexpr std::uint32_t specified_by_trade = 0x00A02D; ///< 1394 Trade Association: IIDC
constexpr std::uint32_t specified_by_point_grey = 0x00B09D; ///< IIDC with own numbers

/** \brief What a camera says about itself before it is known what it can do. */
struct ConfigRom {
  std::uint64_t guid = 0;
  std::uint32_t specification = 0; ///< one of the two above
  std::uint32_t version = 0;       ///< of IIDC: 0x100 is 1.04, 0x101 1.20, 0x102 1.30
  std::uint32_t sub_version = 0;   ///< 0x10 is 1.31, 0x20 is 1.32; 0 when not told
  std::uint64_t registers = 0;     ///< address of the first command register
  std::string maker;               ///< printable ASCII; empty when not told
  std::string model;               ///< likewise
};

/** \brief Reads a quadlet of the ROM by its index. */
using RomQuadlet = std::function<std::uint32_t(std::size_t index)>;

/** \brief Walks through the ROM of a camera: each quadlet of it is read once at most, and
 * none beyond it. Checksums are not looked at: cameras are sold with wrong ones.
 * \throws CameraException Malformed, naming what cannot be; what read throws, but for
 * Unsupported: the ROM ends there */
ConfigRom
readConfigRom(const RomQuadlet& read);

/** \brief A guid as 16 hexadecimal digits. */
std::string
textOfGuid(std::uint64_t guid);

} // namespace pcl::acmap
