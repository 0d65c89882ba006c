#include "mode_list.h"

#include <array>

namespace pcl::acmap {

namespace {

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
