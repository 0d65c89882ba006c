#pragma once

#include <cstdint>

/** \brief Registers of the IIDC specification, as offsets from the camera's command
 * registers, and their bits. Bit 0 of the specification is the highest one. */
namespace pcl::acmap::iidc {

/** \brief Base address of the offsets that registers contain, which are counted in
 * quadlets. */
constexpr std::uint64_t register_space = 0xFFFFF0000000;

constexpr std::uint64_t format_inquiry = 0x100;
constexpr std::uint64_t mode_inquiry = 0x180;  ///< + 4 format
constexpr std::uint64_t rate_inquiry = 0x200;  ///< + 32 format + 4 mode
constexpr std::uint64_t scalable_mode = 0x2E0; ///< + 4 mode: offset of its registers
constexpr std::uint64_t basic_functions = 0x400;
constexpr std::uint64_t advanced_features = 0x480; ///< offset of their registers
constexpr std::uint64_t feature_inquiry = 0x500;   ///< + 4 feature
constexpr std::uint64_t current_rate = 0x600;
constexpr std::uint64_t current_mode = 0x604;
constexpr std::uint64_t current_format = 0x608;
constexpr std::uint64_t iso_channel = 0x60C;
constexpr std::uint64_t power = 0x610;
constexpr std::uint64_t iso_enable = 0x614;
constexpr std::uint64_t one_shot = 0x61C;
constexpr std::uint64_t physical_value =
    0x700; ///< + 4 feature: offset of its registers
constexpr std::uint64_t feature_status = 0x800; ///< + 4 feature
constexpr std::uint64_t trigger_inquiry = 0x530;
constexpr std::uint64_t trigger_mode = 0x830;

/** \brief First registers of the advanced features: identifier of the vendor, and the
 * number of milliseconds for which access is requested. */
constexpr std::uint64_t access_name_high = 0x0;
constexpr std::uint64_t access_name_low = 0x4;
constexpr std::uint32_t point_grey_high = 0x00B09D00;
constexpr std::uint32_t point_grey_low = 0x0004FFFF;

/** \brief Registers specific to Point Grey. */
constexpr std::uint64_t bayer_tile_mapping = 0x1040; ///< four letters
constexpr std::uint64_t frame_info = 0x12F8;        ///< information written into frames
constexpr std::uint32_t frame_counter = 0x00000040; ///< its bit for the frame counter

/** \brief The bit that enables a function, or reports that it is available. */
constexpr std::uint32_t on = 0x80000000;

namespace basic {
constexpr std::uint32_t advanced = 0x80000000;
constexpr std::uint32_t power_switch = 0x00008000;
constexpr std::uint32_t one_shot = 0x00001000;
} // namespace basic

namespace feature {
constexpr std::uint32_t is_there = 0x80000000;
constexpr std::uint32_t has_physical = 0x40000000; ///< inquiry; status: in use
constexpr std::uint32_t can_be_off = 0x04000000;
constexpr std::uint32_t can_be_automatic = 0x02000000;
constexpr std::uint32_t can_be_set = 0x01000000;
constexpr std::uint32_t is_on = 0x02000000; ///< status
constexpr std::uint32_t is_automatic = 0x01000000;
constexpr std::uint32_t value = 0x00000FFF;
} // namespace feature

/** \brief Registers of a mode of format 7, as offsets from its first register. */
namespace scalable {
constexpr std::uint64_t largest_size = 0x000;
constexpr std::uint64_t position = 0x008;
constexpr std::uint64_t size = 0x00C;
constexpr std::uint64_t color = 0x010;
constexpr std::uint64_t color_inquiry = 0x014;
constexpr std::uint64_t packet_range = 0x040;
constexpr std::uint64_t packet_bytes = 0x044;
constexpr std::uint64_t packets = 0x048;
constexpr std::uint64_t color_filter = 0x058;
constexpr std::uint64_t value_setting = 0x07C;
constexpr std::uint64_t bytes = 0x080; ///< total size of these registers

constexpr std::uint32_t apply = 0x40000000;
constexpr std::uint32_t wrong_size = 0x00800000;
constexpr std::uint32_t wrong_packet = 0x00400000;
} // namespace scalable

} // namespace pcl::acmap::iidc
