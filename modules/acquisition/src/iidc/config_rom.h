#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace pcl::acmap {

/** \brief Address of a camera's configuration ROM, and its maximum length in quadlets
 * (IEEE 1212). */
constexpr std::uint64_t config_rom_address = 0xFFFFF0000400;
constexpr std::size_t config_rom_quadlets = 256;

/** \brief Organization that specifies the registers of a camera: key 0x12 of its
 * unit. */
constexpr std::uint32_t specified_by_trade = 0x00A02D; ///< 1394 Trade Association: IIDC
constexpr std::uint32_t specified_by_point_grey = 0x00B09D; ///< IIDC with own numbers

/** \brief Information about a camera from its configuration ROM. */
struct ConfigRom {
  std::uint64_t guid = 0;
  std::uint32_t specification = 0; ///< one of the two above
  std::uint32_t version = 0;       ///< of IIDC: 0x100 is 1.04, 0x101 1.20, 0x102 1.30
  std::uint32_t sub_version = 0;   ///< 0x10 is 1.31, 0x20 is 1.32; 0 if missing
  std::uint64_t registers = 0;     ///< address of the first command register
  std::string maker;               ///< printable ASCII; empty if missing
  std::string model;               ///< printable ASCII; empty if missing
};

/** \brief Reads a quadlet of the ROM by its index. */
using RomQuadlet = std::function<std::uint32_t(std::size_t index)>;

/** \brief Reads the ROM of a camera. Each quadlet is read once at most, and none beyond
 * the end of the ROM. Checksums are ignored, since there are cameras with wrong ones.
 * \throws CameraException Malformed, naming the invalid part; exceptions of read,
 * except for Unsupported, which means that the ROM ends there */
ConfigRom
readConfigRom(const RomQuadlet& read);

/** \brief A guid as 16 hexadecimal digits. */
std::string
textOfGuid(std::uint64_t guid);

} // namespace pcl::acmap
