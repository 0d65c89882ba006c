#include "usb_camera_name.h"

#include "usb_device.h"

#include <pcl/core/exceptions.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace pcl::acmap {

namespace {

constexpr std::size_t serial_digits = 16;

/** \brief Parses a complete text as a number with 1 to max_digits digits. */
std::optional<unsigned>
numberIn(std::string_view text, int base, std::size_t max_digits)
{
  unsigned number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number, base);
  if (text.size() > max_digits || error != std::errc() || rest != end)
    return std::nullopt;
  return number;
}

using Pair = std::optional<std::pair<unsigned, unsigned>>;

/** \brief Parses two numbers that are separated by a colon. */
Pair
pairIn(std::string_view text, int base, std::size_t max_digits)
{
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos)
    return std::nullopt;
  const auto first = numberIn(text.substr(0, colon), base, max_digits);
  const auto second = numberIn(text.substr(colon + 1), base, max_digits);
  return first && second ? Pair({*first, *second}) : std::nullopt;
}

bool
isHexadecimal(const std::string& text)
{
  return text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
}

} // namespace

bool
UsbCameraName::fits(const UsbCamera& camera) const
{
  if (!place.empty())
    return camera.place == place;
  if (kind)
    return camera.vendor == kind->first && camera.product == kind->second;
  return camera.vendor == point_grey;
}

UsbCameraName
parseUsbCameraName(const std::string& text)
{
  constexpr std::string_view kind_mark = "usb:";
  UsbCameraName name;
  if (text.empty())
    return name;
  if (text.size() == serial_digits && isHexadecimal(text)) {
    name.serial = text;
    std::transform(text.begin(), text.end(), name.serial.begin(), [](char letter) {
      return letter >= 'A' && letter <= 'F' ? static_cast<char>(letter + 'a' - 'A')
                                            : letter;
    });
    return name;
  }
  if (text.compare(0, kind_mark.size(), kind_mark) == 0) {
    if (const Pair kind =
            pairIn(std::string_view(text).substr(kind_mark.size()), 16, 4)) {
      name.kind.emplace(kind->first, kind->second);
      return name;
    }
  }
  else if (const Pair place = pairIn(text, 10, 3)) {
    name.place = std::to_string(place->first) + ":" + std::to_string(place->second);
    return name;
  }
  throw acmap::BadArgument("camera '" + text +
                           "': not a serial number of 16 hexadecimal digits, nor "
                           "BUS:ADDRESS, nor usb:VENDOR:PRODUCT in hexadecimal");
}

} // namespace pcl::acmap
