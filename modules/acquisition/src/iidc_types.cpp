#include "iidc/config_rom.h"

#include <pcl/acquisition/iidc_types.h>

#include <array>

namespace pcl {

std::string
IidcIdentity::serial() const
{
  return acmap::textOfGuid(guid);
}

const char*
nameOf(IidcColor color)
{
  constexpr std::array<const char*, 11> names = {"Mono8",
                                                 "YUV411",
                                                 "YUV422",
                                                 "YUV444",
                                                 "RGB8",
                                                 "Mono16",
                                                 "RGB16",
                                                 "signed Mono16",
                                                 "signed RGB16",
                                                 "Raw8",
                                                 "Raw16"};
  return names.at(static_cast<std::size_t>(color));
}

const char*
nameOf(IidcFeature feature)
{
  switch (feature) {
  case IidcFeature::Brightness:
    return "brightness";
  case IidcFeature::Exposure:
    return "exposure";
  case IidcFeature::Sharpness:
    return "sharpness";
  case IidcFeature::WhiteBalance:
    return "white balance";
  case IidcFeature::Saturation:
    return "saturation";
  case IidcFeature::Gamma:
    return "gamma";
  case IidcFeature::Shutter:
    return "shutter";
  case IidcFeature::Gain:
    return "gain";
  case IidcFeature::FrameRate:
    return "frame rate";
  case IidcFeature::Pan:
    return "pan";
  }
  return "feature";
}

int
IidcMode::cameras() const
{
  switch (color) {
  case IidcColor::Mono8:
  case IidcColor::Raw8:
    return 1;
  case IidcColor::Mono16:
  case IidcColor::Raw16:
    return 2;
  case IidcColor::Rgb8:
    return 3;
  default:
    return 0;
  }
}

std::size_t
IidcMode::bytes() const
{
  constexpr std::array<std::size_t, 11> bits = {
      8, 12, 16, 24, 24, 16, 48, 16, 48, 8, 16};
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
         bits.at(static_cast<std::size_t>(color)) / 8;
}

std::string
IidcMode::text() const
{
  return std::to_string(format) + ":" + std::to_string(mode) + " " +
         std::to_string(width) + "x" + std::to_string(height) + " " + nameOf(color);
}

} // namespace pcl
