#include "register_bus.h"

#include "emulation/config_rom.h"
#include "iidc/config_rom.h"
#include "iidc/registers.h"

#include <pcl/acquisition/iidc_types.h>

#include <cstring>

namespace pcl::acmap::test {

namespace {

using Registers = std::map<std::uint64_t, std::uint32_t>;

constexpr std::uint64_t commands = 0xFFFFF0F00000; // from the ROM of the emulated
                                                   // camera
constexpr std::uint64_t own_registers = 0x1000;    // of the manufacturer, relative to
                                                   // the commands
constexpr std::uint64_t scalable_registers = 0x2000;
constexpr std::uint64_t physical_registers = 0x3000;

/** \brief An offset relative to the commands in the format of registers. */
std::uint32_t
quadletsTo(std::uint64_t offset)
{
  return static_cast<std::uint32_t>((commands + offset - iidc::register_space) / 4);
}

void
addModes(Registers& registers)
{
  const auto set = [&](std::uint64_t offset, std::uint32_t value) {
    registers[commands + offset] = value;
  };
  constexpr std::uint32_t formats_0_and_7 = 0x81000000;
  constexpr std::uint32_t modes_0_and_5 = 0x84000000; // 160 x 120, 640 x 480
  constexpr std::uint32_t all_rates = 0xFC000000;
  set(iidc::format_inquiry, formats_0_and_7);
  set(iidc::mode_inquiry, modes_0_and_5);
  set(iidc::mode_inquiry + 4 * 7, iidc::on);
  set(iidc::rate_inquiry, all_rates);
  set(iidc::rate_inquiry + 4 * 5, all_rates);
  set(iidc::scalable_mode, quadletsTo(scalable_registers));
  using namespace iidc::scalable;
  constexpr std::uint32_t small = 16U << 16 | 8;
  constexpr std::uint32_t grey_and_three = 0x88000000;
  constexpr std::uint32_t packets_of_8_to_64 = 8U << 16 | 64;
  set(scalable_registers + largest_size, small);
  set(scalable_registers + color_inquiry, grey_and_three);
  set(scalable_registers + packet_range, packets_of_8_to_64);
  set(scalable_registers + value_setting, iidc::on);
  for (const std::uint64_t offset : {position, size, color, packet_bytes})
    set(scalable_registers + offset, 0);
}

void
addFeatures(Registers& registers)
{
  constexpr std::uint32_t inquiry = 0xC7000000 | 1U << 12 | 500;
  constexpr std::uint32_t status = 0x82000000 | 100;
  for (const IidcFeature feature : {IidcFeature::WhiteBalance,
                                    IidcFeature::Shutter,
                                    IidcFeature::Gain,
                                    IidcFeature::FrameRate}) {
    const auto number = static_cast<std::uint64_t>(feature);
    registers[commands + iidc::feature_inquiry + 4 * number] = inquiry;
    registers[commands + iidc::feature_status + 4 * number] = status;
    const std::uint64_t physical = physical_registers + 0x10 * number;
    registers[commands + iidc::physical_value + 4 * number] = quadletsTo(physical);
    std::uint64_t offset = commands + physical;
    for (const float value : {0.001F, 60.0F, 15.0F}) {
      std::memcpy(&registers[offset], &value, sizeof value);
      offset += 4;
    }
  }
  registers[commands + iidc::trigger_inquiry] = iidc::on;
  registers[commands + iidc::trigger_mode] = iidc::on;
}

/** \brief The registers of a valid camera. */
Registers
soundRegisters()
{
  Registers registers;
  std::uint64_t address = config_rom_address;
  for (const std::uint32_t quadlet : configRomOf({})) {
    registers[address] = quadlet;
    address += 4;
  }
  addModes(registers);
  addFeatures(registers);
  for (const std::uint64_t offset : {iidc::current_rate,
                                     iidc::current_mode,
                                     iidc::current_format,
                                     iidc::iso_channel,
                                     iidc::power,
                                     iidc::iso_enable,
                                     iidc::one_shot,
                                     own_registers + iidc::access_name_high,
                                     own_registers + iidc::access_name_low})
    registers[commands + offset] = 0;
  using namespace iidc::basic;
  registers[commands + iidc::basic_functions] = advanced | power_switch | one_shot;
  registers[commands + iidc::advanced_features] = quadletsTo(own_registers);
  registers[commands + iidc::bayer_tile_mapping] = 0x47425247; // GBRG
  registers[commands + iidc::frame_info] = iidc::on;
  return registers;
}

/** \brief Maps two bytes to an address in or near the ROM, or in the commands. */
std::uint64_t
addressOf(std::uint16_t number)
{
  constexpr std::uint16_t of_commands = 0x8000;
  const std::uint64_t offset = std::uint64_t{4} * (number & (of_commands - 1));
  return offset + ((number & of_commands) != 0 ? commands : iidc::register_space);
}

} // namespace

HostileCamera::HostileCamera(FuzzedBytes numbers)
: stream(nullptr, 0)
{
  static const Registers sound = soundRegisters();
  registers = sound;
  constexpr std::size_t max_accesses = 4096;
  const std::size_t failing = numbers.number<std::uint16_t>();
  failing_access = failing > 0 && failing < max_accesses ? failing : max_accesses;
  const auto lies = numbers.byte();
  if ((lies & 0x80) != 0)
    failure = CameraFault::Unplugged;
  refuses_unknown = (lies & 0x40) != 0;
  for (int i = 0; i < (lies & 0x3F); ++i) {
    const std::uint64_t address = addressOf(numbers.number<std::uint16_t>());
    registers[address] = numbers.number<std::uint32_t>();
  }
  stream = numbers;
}

std::uint32_t&
RegisterBus::access(std::uint64_t address)
{
  require(address % 4 == 0 && address >> 48 == 0);
  if (camera_.failing_access == 0)
    throw CameraException(camera_.failure, place() + ": does not answer");
  --camera_.failing_access;
  const auto found = camera_.registers.find(address);
  if (found != camera_.registers.end())
    return found->second;
  if (camera_.refuses_unknown)
    throw CameraException(CameraFault::Unsupported, place() + ": has no such register");
  return camera_.registers[address];
}

std::uint32_t
RegisterBus::readQuadlet(std::uint64_t address)
{
  return access(address);
}

void
RegisterBus::writeQuadlet(std::uint64_t address, std::uint32_t value)
{
  // Settles at once, because waiting for a camera takes time.
  const bool is_to_settle = value == iidc::scalable::apply;
  access(address) = is_to_settle ? iidc::on : value;
}

void
RegisterBus::startStream(std::size_t frame_bytes, std::size_t)
{
  constexpr std::size_t max_bytes = 65536; // frames with more take too long
  require(frame_bytes > 0);
  if (frame_bytes > max_bytes)
    throw CameraException(CameraFault::Failed, place() + ": has no memory");
  frame_bytes_ = frame_bytes;
}

IidcWait
RegisterBus::nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout)
{
  require(timeout.count() >= 0 && frame_bytes_ > 0);
  if (camera_.stream.left() == 0)
    throw CameraException(CameraFault::Unplugged, place() + ": is gone");
  const auto what = camera_.stream.byte();
  if (what == 0)
    return IidcWait::TimedOut;
  // Larger numbers mean that more of the frame is missing.
  const std::size_t missing = what < 0x80 ? 0 : frame_bytes_ * (what - 0x7F) / 0x80;
  stamp_ += std::uint64_t{1000} * (what & 0x7F);
  frame.bytes.assign(frame_bytes_ - missing, what);
  frame.is_whole = missing == 0;
  frame.stamp = stamp_;
  const auto counter = camera_.stream.number<std::uint32_t>();
  if (frame.bytes.size() >= sizeof counter)
    std::memcpy(frame.bytes.data(), &counter, sizeof counter);
  return IidcWait::Frame;
}

} // namespace pcl::acmap::test
