#include "images/image_codecs.h"

#include <cctype>
#include <string>

namespace pcl::acmap {

namespace {

/** \brief Returns the next number of a header and advances the position behind it.
 * Comments begin with # and extend to the end of the line. */
std::uint64_t
readNumber(const ImageBytes& bytes, std::size_t& at)
{
  constexpr std::uint64_t maximum = std::uint64_t{1} << 31;
  while (at < bytes.size() && (std::isspace(bytes[at]) != 0 || bytes[at] == '#'))
    if (bytes[at++] == '#')
      while (at < bytes.size() && bytes[at] != '\n')
        ++at;
  if (at == bytes.size() || std::isdigit(bytes[at]) == 0)
    throw DamagedImage("lacks a number in its header");
  std::uint64_t number = 0;
  while (at < bytes.size() && std::isdigit(bytes[at]) != 0) {
    number = 10 * number + (bytes[at++] - '0');
    if (number >= maximum)
      throw DamagedImage("has too high a number in its header");
  }
  return number;
}

} // namespace

bool
isPnm(const ImageBytes& bytes)
{
  return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '6') &&
         (std::isspace(bytes[2]) != 0 || bytes[2] == '#');
}

RgbImage
decodePnm(const ImageBytes& bytes)
{
  const std::size_t channels = bytes[1] == '6' ? 3 : 1;
  std::size_t at = 2;
  const std::uint64_t width = readNumber(bytes, at);
  const std::uint64_t height = readNumber(bytes, at);
  if (readNumber(bytes, at) != 255)
    throw DamagedImage("is no PGM or PPM of 8 bits: its brightest value is not 255");
  if (at == bytes.size() || std::isspace(bytes[at++]) == 0)
    throw DamagedImage("lacks a space behind its header");
  requireImageSize(width, height, 1, bytes.size() - at);
  const std::uint64_t needed = channels * width * height;
  if (bytes.size() - at != needed)
    throw DamagedImage("its header tells of " + std::to_string(needed) + " bytes, " +
                       std::to_string(bytes.size() - at) + " follow it");
  RgbImage image{
      static_cast<std::int32_t>(width), static_cast<std::int32_t>(height), {}};
  image.values.reserve(3 * width * height);
  for (; at < bytes.size(); at += channels)
    for (std::size_t i = 0; i < 3; ++i)
      image.values.push_back(bytes[channels == 3 ? at + i : at]);
  return image;
}

GrayImage16
decodeGrayPnm(const ImageBytes& bytes)
{
  constexpr std::uint64_t max_byte = 255, max_word = 65535;
  if (bytes[1] != '5')
    throw DamagedImage("is a PPM, not an image of one channel");
  std::size_t at = 2;
  const std::uint64_t width = readNumber(bytes, at);
  const std::uint64_t height = readNumber(bytes, at);
  const std::uint64_t brightest = readNumber(bytes, at);
  if (brightest == 0 || brightest > max_word)
    throw DamagedImage("is no PGM: its brightest value is not within 1 to 65535");
  if (at == bytes.size() || std::isspace(bytes[at++]) == 0)
    throw DamagedImage("lacks a space behind its header");
  requireImageSize(width, height, 1, bytes.size() - at);
  const std::uint64_t bytes_per_pixel = brightest > max_byte ? 2 : 1;
  const std::uint64_t needed = bytes_per_pixel * width * height;
  if (bytes.size() - at != needed)
    throw DamagedImage("its header tells of " + std::to_string(needed) + " bytes, " +
                       std::to_string(bytes.size() - at) + " follow it");
  GrayImage16 image{
      static_cast<std::int32_t>(width), static_cast<std::int32_t>(height), {}};
  image.values.reserve(width * height);
  for (; at < bytes.size(); at += bytes_per_pixel)
    image.values.push_back(static_cast<std::uint16_t>(
        bytes_per_pixel == 2 ? bytes[at] << 8 | bytes[at + 1] : bytes[at]));
  return image;
}

} // namespace pcl::acmap
