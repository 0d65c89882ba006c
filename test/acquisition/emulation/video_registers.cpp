#include "video_registers.h"

#include "iidc_addresses.h"

#include <algorithm>

namespace pcl::acmap::test {
namespace {

using namespace iidc;

constexpr std::uint32_t width = 640;
constexpr std::uint32_t height = 480;
constexpr std::uint32_t unit = 8; ///< pixels, of sizes and positions
constexpr std::uint32_t packet_unit = 4;
constexpr std::uint32_t packet_maximum = 4096; ///< S400

// Offsets in a mode of Format_7.
constexpr std::uint32_t position = 0x008;
constexpr std::uint32_t size = 0x00C;
constexpr std::uint32_t coding_id = 0x010;
constexpr std::uint32_t coding_inquiry = 0x014;
constexpr std::uint32_t pixels = 0x034;
constexpr std::uint32_t bytes_low = 0x03C;
constexpr std::uint32_t packet_limits = 0x040;
constexpr std::uint32_t packet_size = 0x044;
constexpr std::uint32_t packets = 0x048;
constexpr std::uint32_t value_setting = 0x07C;

// Bits of VALUE_SETTING.
constexpr std::uint32_t setting_1 = 0x40000000;
constexpr std::uint32_t error_1 = 0x00800000;
constexpr std::uint32_t error_2 = 0x00400000;

std::uint32_t
pixelBytes(std::uint32_t coding)
{
  switch (coding) {
  case Rgb8:
    return 3;
  case Mono16:
  case Raw16:
    return 2;
  default:
    return 1;
  }
}

constexpr std::uint32_t
bit(std::uint32_t number)
{
  return 0x80000000U >> number;
}

constexpr std::uint32_t
csrOf(std::uint32_t mode)
{
  return format7_base + 0x100 * mode;
}

} // namespace

VideoRegisters::VideoRegisters(RegisterMap& registers, std::uint32_t setting_reads)
: registers_(registers)
, setting_reads_(setting_reads)
{
  registers_.fix(format_inquiry, bit(0) | bit(7));
  addFixedFormat();
  registers_.fix(mode_inquiry + 4 * 7, bit(0) | bit(3));
  addScalableMode(0, bit(Rgb8) | bit(Mono8) | bit(Raw8), Rgb8);
  addScalableMode(3, bit(Mono16) | bit(Raw16), Raw16);
  registers_.keep(current_format, 0, 7U << 29);
  registers_.keep(current_mode, 4U << 29, 7U << 29);
  registers_.keep(current_rate, 3U << 29, 7U << 29);
  registers_.fix(mode_error, 0);
}

void
VideoRegisters::addFixedFormat()
{
  const std::uint32_t rates = bit(0) | bit(1) | bit(2) | bit(3) | bit(4);
  registers_.fix(mode_inquiry, bit(4) | bit(5));
  registers_.fix(rate_inquiry + 4 * 4, rates);
  registers_.fix(rate_inquiry + 4 * 5, rates);
}

void
VideoRegisters::addScalableMode(std::uint32_t mode,
                                std::uint32_t codings,
                                std::uint32_t coding)
{
  const std::uint32_t base = csrOf(mode);
  registers_.fix(format7_csr + 4 * mode, (command_base + base) / 4);
  registers_.fix(base + 0x000, width << 16 | height);
  registers_.fix(base + 0x004, unit << 16 | unit);
  registers_.keep(base + position, 0);
  registers_.keep(base + size, width << 16 | height);
  registers_.keep(base + coding_id, coding << 24, 0xFF000000);
  registers_.fix(base + coding_inquiry, codings);
  for (std::uint32_t inquiry = 0x018; inquiry < 0x034; inquiry += 4)
    registers_.fix(base + inquiry, 0);
  registers_.fix(base + pixels, 0);
  registers_.fix(base + 0x038, 0);
  registers_.fix(base + bytes_low, 0);
  registers_.fix(base + packet_limits, 0);
  registers_.keep(base + packet_size, 1920U << 16, 0xFFFF0000);
  registers_.fix(base + packets, 0);
  registers_.fix(base + 0x04C, unit << 16 | unit);
  registers_.fix(base + 0x054, 8U << 24);
  registers_.fix(base + 0x058, 0);
  registers_.keep(base + value_setting, present, setting_1);
  settle(base);
}

/** \brief Computes the values that depend on size, position and coding. */
void
VideoRegisters::settle(std::uint32_t base)
{
  const std::uint32_t area = registers_.at(base + size);
  const std::uint32_t at = registers_.at(base + position);
  const std::uint32_t columns = area >> 16;
  const std::uint32_t rows = area & 0xFFFF;
  const std::uint32_t coding = registers_.at(base + coding_id) >> 24;
  const bool fits = columns > 0 && rows > 0 && columns % unit == 0 &&
                    rows % unit == 0 && (at >> 16) + columns <= width &&
                    (at & 0xFFFF) + rows <= height && coding < 32 &&
                    (registers_.at(base + coding_inquiry) & bit(coding));
  if (!fits) {
    registers_.set(base + value_setting, present | error_1);
    return;
  }
  registers_.set(base + value_setting, present);
  registers_.set(base + pixels, columns * rows);
  registers_.set(base + bytes_low, columns * rows * pixelBytes(coding));
  registers_.set(base + packet_limits, packet_unit << 16 | packet_maximum);
  checkPacket(base);
}

void
VideoRegisters::checkPacket(std::uint32_t base)
{
  const std::uint32_t chosen = registers_.at(base + packet_size) >> 16;
  const std::uint32_t flags = registers_.at(base + value_setting) & ~error_2;
  if (chosen == 0 || chosen % packet_unit != 0 || chosen > packet_maximum) {
    registers_.set(base + value_setting, flags | error_2);
    return;
  }
  registers_.set(base + value_setting, flags);
  const std::uint32_t total = registers_.at(base + bytes_low);
  const std::uint32_t count = (total + chosen - 1) / chosen;
  registers_.set(base + packets, count);
  // The low half recommends a packet size, for 15 frames per second with 8000 packets.
  const std::uint32_t wish = (total * 15 / 8000 + packet_unit) / packet_unit;
  registers_.set(base + packet_size,
                 chosen << 16 | std::min(wish * packet_unit, packet_maximum));
}

void
VideoRegisters::written(std::uint32_t offset)
{
  for (const std::uint32_t mode : {0U, 3U}) {
    const std::uint32_t base = csrOf(mode);
    if (offset == base + packet_size)
      checkPacket(base);
    if (offset != base + value_setting || !(registers_.at(offset) & setting_1))
      continue;
    settle(base);
    busy_reads_ = setting_reads_;
    if (busy_reads_ > 0)
      registers_.set(offset, registers_.at(offset) | setting_1);
  }
  if (offset == current_format || offset == current_mode || offset == current_rate)
    registers_.set(mode_error, setting() ? 0 : bit(0));
}

void
VideoRegisters::wasRead(std::uint32_t offset)
{
  for (const std::uint32_t mode : {0U, 3U})
    if (offset == csrOf(mode) + value_setting && busy_reads_ > 0 && --busy_reads_ == 0)
      registers_.set(offset, registers_.at(offset) & ~setting_1);
}

std::optional<VideoSetting>
VideoRegisters::setting() const
{
  const std::uint32_t format = registers_.at(current_format) >> 29;
  const std::uint32_t mode = registers_.at(current_mode) >> 29;
  if (format == 0)
    return fixedSetting(mode, registers_.at(current_rate) >> 29);
  if (format == 7 && registers_.has(format7_csr + 4 * mode))
    return scalableSetting(mode);
  return std::nullopt;
}

std::optional<VideoSetting>
VideoRegisters::fixedSetting(std::uint32_t mode, std::uint32_t rate) const
{
  const std::uint32_t inquiry = rate_inquiry + 4 * mode;
  if (!registers_.has(inquiry) || !(registers_.at(inquiry) & bit(rate)))
    return std::nullopt;
  VideoSetting setting;
  setting.mode = mode;
  setting.coding = mode == 4 ? Rgb8 : Mono8;
  setting.image_bytes = std::size_t{width} * height * pixelBytes(setting.coding);
  setting.transfer_bytes = setting.image_bytes; // at every rate whole packets are sent
  setting.period = std::chrono::duration<double>(1 / (1.875 * (1U << rate)));
  return setting;
}

std::optional<VideoSetting>
VideoRegisters::scalableSetting(std::uint32_t mode) const
{
  const std::uint32_t base = csrOf(mode);
  if (registers_.at(base + value_setting) & (error_1 | error_2))
    return std::nullopt;
  VideoSetting setting;
  setting.format = 7;
  setting.mode = mode;
  setting.coding = registers_.at(base + coding_id) >> 24;
  setting.width = registers_.at(base + size) >> 16;
  setting.height = registers_.at(base + size) & 0xFFFF;
  setting.left = registers_.at(base + position) >> 16;
  setting.top = registers_.at(base + position) & 0xFFFF;
  setting.image_bytes =
      std::size_t{setting.width} * setting.height * pixelBytes(setting.coding);
  const std::uint32_t count = registers_.at(base + packets);
  setting.transfer_bytes =
      std::size_t{count} * (registers_.at(base + packet_size) >> 16);
  setting.period = std::chrono::duration<double>(count / 8000.0);
  return setting;
}

} // namespace pcl::acmap::test
