#pragma once

#include <cstdint>

/** \brief Register addresses of IIDC 1.30 and Point Grey. They are defined again here,
 * so that the tests find errors in the definitions of the library. */
namespace pcl::acmap::test::iidc {

constexpr std::uint64_t csr_space = 0xFFFFF0000000;
constexpr std::uint64_t config_rom = csr_space + 0x400;
constexpr std::uint32_t command_base = 0xF00000; ///< of the command registers, from CSR
constexpr std::uint64_t commands = csr_space + command_base;

constexpr std::uint32_t present = 0x80000000; ///< bit in inquiries and absolute values

// Offsets relative to the command registers.
constexpr std::uint32_t initialize = 0x000;
constexpr std::uint32_t format_inquiry = 0x100;
constexpr std::uint32_t mode_inquiry = 0x180; ///< + 4 format
constexpr std::uint32_t rate_inquiry = 0x200; ///< + 32 format + 4 mode
constexpr std::uint32_t format7_csr = 0x2E0;  ///< + 4 mode
constexpr std::uint32_t basic_functions = 0x400;
constexpr std::uint32_t features_high = 0x404;
constexpr std::uint32_t features_low = 0x408;
constexpr std::uint32_t optional_functions = 0x40C;
constexpr std::uint32_t advanced_csr = 0x480;
constexpr std::uint32_t feature_inquiry = 0x500; ///< + 4 feature
constexpr std::uint32_t current_rate = 0x600;
constexpr std::uint32_t current_mode = 0x604;
constexpr std::uint32_t current_format = 0x608;
constexpr std::uint32_t iso_channel = 0x60C;
constexpr std::uint32_t power = 0x610;
constexpr std::uint32_t iso_enable = 0x614;
constexpr std::uint32_t one_shot = 0x61C;
constexpr std::uint32_t mode_error = 0x628;
constexpr std::uint32_t software_trigger = 0x62C;
constexpr std::uint32_t data_depth = 0x630;
constexpr std::uint32_t absolute_csr = 0x700;   ///< + 4 feature
constexpr std::uint32_t feature_status = 0x800; ///< + 4 feature

// Addresses that the camera may choose, as offsets relative to the command registers.
constexpr std::uint32_t format7_base = 0x4000;  ///< + 256 mode
constexpr std::uint32_t absolute_base = 0x5000; ///< + 16 feature

// Point Grey's registers in the advanced space.
constexpr std::uint32_t advanced_base = 0x1000;
constexpr std::uint32_t access_high = 0x1000;
constexpr std::uint32_t access_low = 0x1004;
constexpr std::uint32_t bayer_tiles = 0x1040;
constexpr std::uint32_t image_data_format = 0x1048;
constexpr std::uint32_t frame_info = 0x12F8;

constexpr std::uint32_t on = 0x80000000;

/** \brief Features by their index in the tables; those of the low half start at 32. */
enum Feature : std::uint32_t {
  Brightness = 0,
  AutoExposure = 1,
  WhiteBalance = 3,
  Shutter = 7,
  Gain = 8,
  Trigger = 12,
  FrameRate = 15,
  Pan = 33
};

// Bits of the feature status.
constexpr std::uint32_t absolute_control = 0x40000000;
constexpr std::uint32_t feature_on = 0x02000000;
constexpr std::uint32_t feature_auto = 0x01000000;

/** \brief Codes of colour codings. */
enum Coding : std::uint32_t { Mono8 = 0, Rgb8 = 4, Mono16 = 5, Raw8 = 9, Raw16 = 10 };

} // namespace pcl::acmap::test::iidc
