#include "camera_modes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <thread>

namespace pcl::acmap {

namespace {

/** Number of packets per second on the bus. */
constexpr double packets_per_second = 8000;

[[noreturn]] void
refuse(CameraFault fault, const RegisterAccess& registers, const std::string& what)
{
  throw CameraException(fault, registers.place() + ": " + what);
}

RegisterAccess
registersOf(const RegisterAccess& camera, const IidcMode& mode)
{
  const auto registers =
      camera.behind(iidc::scalable_mode + 4 * static_cast<std::uint64_t>(mode.mode));
  if (!registers)
    refuse(CameraFault::Unsupported, camera, "has no mode " + mode.text());
  return *registers;
}

/** Applies values that belong together, as cameras since IIDC 1.30 require. */
void
applyValues(const RegisterAccess& registers,
            std::uint32_t error,
            const std::string& values)
{
  using namespace iidc;
  const auto present = registers.tryRead(scalable::value_setting).value_or(0);
  if ((present & on) == 0)
    return;
  registers.write(scalable::value_setting, scalable::apply);
  for (int tries = 0; tries < 200; ++tries) {
    const std::uint32_t state = registers.read(scalable::value_setting);
    if ((state & scalable::apply) == 0) {
      if ((state & error) != 0)
        refuse(CameraFault::Unsupported, registers, "refuses " + values);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  refuse(CameraFault::Silent, registers, "does not settle after " + values);
}

struct PacketRange {
  std::size_t unit;
  std::size_t maximum;
};

PacketRange
packetRange(const RegisterAccess& registers, const IidcMode& mode)
{
  const std::uint32_t range = registers.read(iidc::scalable::packet_range);
  const PacketRange packets{range >> 16, range & 0xFFFF};
  if (packets.unit == 0 || packets.unit > packets.maximum)
    refuse(CameraFault::Malformed,
           registers,
           "packets of mode " + mode.text() + " in steps of " +
               std::to_string(packets.unit) + " up to " +
               std::to_string(packets.maximum) + " bytes");
  return packets;
}

/** Number of packets per frame: as reported by the camera, unless that is
 * implausible. */
std::size_t
packetsOfFrame(const RegisterAccess& registers,
               const IidcMode& mode,
               std::size_t packet_bytes)
{
  const std::size_t minimum = (mode.bytes() + packet_bytes - 1) / packet_bytes;
  const std::size_t told = registers.tryRead(iidc::scalable::packets).value_or(0);
  return told >= minimum && told <= minimum + 1 ? told : minimum;
}

struct FixedMode {
  int width;
  int height;
  IidcColor color;
};

using Color = IidcColor;

/** Formats 0 to 2 of the specification; a width of 0 means that there is no such
 * mode. */
constexpr std::array<std::array<FixedMode, 8>, 3> fixed_modes = {{
    {{{160, 120, Color::Yuv444},
      {320, 240, Color::Yuv422},
      {640, 480, Color::Yuv411},
      {640, 480, Color::Yuv422},
      {640, 480, Color::Rgb8},
      {640, 480, Color::Mono8},
      {640, 480, Color::Mono16},
      {0, 0, Color::Mono8}}},
    {{{800, 600, Color::Yuv422},
      {800, 600, Color::Rgb8},
      {800, 600, Color::Mono8},
      {1024, 768, Color::Yuv422},
      {1024, 768, Color::Rgb8},
      {1024, 768, Color::Mono8},
      {800, 600, Color::Mono16},
      {1024, 768, Color::Mono16}}},
    {{{1280, 960, Color::Yuv422},
      {1280, 960, Color::Rgb8},
      {1280, 960, Color::Mono8},
      {1600, 1200, Color::Yuv422},
      {1600, 1200, Color::Rgb8},
      {1600, 1200, Color::Mono8},
      {1280, 960, Color::Mono16},
      {1600, 1200, Color::Mono16}}},
}};

constexpr int largest_side = 32768;
constexpr unsigned colors = 11;

bool
hasBit(std::uint32_t inquiry, unsigned bit)
{
  return (inquiry & (iidc::on >> bit)) != 0;
}

void
addFixed(const RegisterAccess& camera,
         unsigned format,
         unsigned number,
         std::vector<IidcMode>& modes)
{
  const FixedMode& fixed = fixed_modes[format][number];
  if (fixed.width == 0)
    return;
  const std::uint32_t inquiry =
      camera.tryRead(iidc::rate_inquiry + 32 * format + 4 * number).value_or(0);
  IidcMode mode{static_cast<int>(format),
                static_cast<int>(number),
                fixed.width,
                fixed.height,
                fixed.color,
                {}};
  for (unsigned rate = 0; rate < 8; ++rate)
    if (hasBit(inquiry, rate))
      mode.rates.push_back(fixedRate(rate));
  if (!mode.rates.empty())
    modes.push_back(mode);
}

void
addScalable(const RegisterAccess& camera, unsigned number, std::vector<IidcMode>& modes)
{
  const auto registers = camera.behind(iidc::scalable_mode + 4 * number);
  if (!registers)
    return;
  const std::uint32_t size =
      registers->tryRead(iidc::scalable::largest_size).value_or(0);
  const auto width = static_cast<int>(size >> 16);
  const auto height = static_cast<int>(size & 0xFFFF);
  if (width == 0 || height == 0 || width > largest_side || height > largest_side)
    return;
  const std::uint32_t inquiry =
      registers->tryRead(iidc::scalable::color_inquiry).value_or(0);
  for (unsigned color = 0; color < colors; ++color)
    if (hasBit(inquiry, color))
      modes.push_back({scalable_format,
                       static_cast<int>(number),
                       width,
                       height,
                       static_cast<IidcColor>(color),
                       {}});
}

} // namespace

StreamSetting
setFixedMode(const RegisterAccess& camera, const IidcMode& mode, float rate)
{
  const auto distance = [rate](float candidate) { return std::abs(candidate - rate); };
  const float nearest = *std::min_element(
      mode.rates.begin(), mode.rates.end(), [&](float one, float other) {
        return distance(one) < distance(other);
      });
  std::uint32_t number = 0;
  while (number < 7 && fixedRate(number) < nearest)
    ++number;
  camera.write(iidc::current_format, static_cast<std::uint32_t>(mode.format) << 29);
  camera.write(iidc::current_mode, static_cast<std::uint32_t>(mode.mode) << 29);
  camera.write(iidc::current_rate, number << 29);
  return {mode.bytes(), nearest};
}

StreamSetting
setScalableMode(const RegisterAccess& camera, const IidcMode& mode, float rate)
{
  using namespace iidc;
  const RegisterAccess registers = registersOf(camera, mode);
  camera.write(current_format, std::uint32_t{7} << 29);
  camera.write(current_mode, static_cast<std::uint32_t>(mode.mode) << 29);
  registers.write(scalable::position, 0);
  registers.write(scalable::size,
                  static_cast<std::uint32_t>(mode.width) << 16 |
                      static_cast<std::uint32_t>(mode.height));
  registers.write(scalable::color, static_cast<std::uint32_t>(mode.color) << 24);
  applyValues(registers, scalable::wrong_size, "mode " + mode.text());

  const PacketRange range = packetRange(registers, mode);
  const double wanted = static_cast<double>(mode.bytes()) * static_cast<double>(rate) /
                        packets_per_second;
  std::size_t packet = range.maximum / range.unit * range.unit;
  if (rate > 0)
    packet = std::min(
        packet,
        static_cast<std::size_t>(std::ceil(wanted / static_cast<double>(range.unit))) *
            range.unit);
  packet = std::max(packet, range.unit);
  registers.write(scalable::packet_bytes, static_cast<std::uint32_t>(packet) << 16);
  applyValues(registers,
              scalable::wrong_packet,
              "packets of " + std::to_string(packet) + " bytes");
  const std::size_t count = packetsOfFrame(registers, mode, packet);
  return {count * packet,
          static_cast<float>(packets_per_second / static_cast<double>(count))};
}

std::string
scalableColorFilter(const RegisterAccess& camera, const IidcMode& mode)
{
  constexpr std::array<const char*, 4> filters = {"RGGB", "GBRG", "GRBG", "BGGR"};
  const auto filter = registersOf(camera, mode).tryRead(iidc::scalable::color_filter);
  if (!filter || *filter >> 24 >= filters.size())
    return "";
  return filters.at(*filter >> 24);
}

float
fixedRate(unsigned number)
{
  return 1.875F * static_cast<float>(1U << number);
}

std::vector<IidcMode>
listModes(const RegisterAccess& camera)
{
  std::vector<IidcMode> modes;
  const std::uint32_t formats = camera.tryRead(iidc::format_inquiry).value_or(0);
  for (unsigned format = 0; format < 8; ++format) {
    if (!hasBit(formats, format) ||
        (format >= fixed_modes.size() && format != scalable_format))
      continue;
    const std::uint32_t inquiry =
        camera.tryRead(iidc::mode_inquiry + 4 * format).value_or(0);
    for (unsigned mode = 0; mode < 8; ++mode) {
      if (!hasBit(inquiry, mode))
        continue;
      if (format == scalable_format)
        addScalable(camera, mode, modes);
      else
        addFixed(camera, format, mode, modes);
    }
  }
  return modes;
}

} // namespace pcl::acmap
