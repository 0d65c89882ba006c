#include "files/byte_source.h"
#include "images/image_codecs.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/image_file.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/output_file.h>

#include <algorithm>

namespace pcl {

namespace acmap {

void
requireImageSize(std::uint64_t width,
                 std::uint64_t height,
                 double pixels_per_byte,
                 std::size_t bytes)
{
  const std::string size = sizeText(width, height) + " pixels";
  if (width == 0 || height == 0)
    throw DamagedImage("has no pixels: " + size);
  // Both are below 2^31.
  if (width * height > max_pixels)
    throw DamagedImage("claims " + size + ", at most " + std::to_string(max_pixels) +
                       " are read");
  const auto pixels = static_cast<double>(width * height);
  if (pixels > pixels_per_byte * static_cast<double>(bytes))
    throw DamagedImage("is truncated: claims " + size + " but has " +
                       std::to_string(bytes) + " bytes");
}

void
requireImageValues(std::int32_t width,
                   std::int32_t height,
                   std::size_t channels,
                   std::size_t values)
{
  const std::uint64_t pixels =
      width > 0 && height > 0
          ? static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height)
          : 0;
  if (pixels == 0 || pixels > max_pixels || values != channels * pixels)
    throw acmap::BadArgument("an image of " + sizeText(width, height) +
                             " pixels with " + std::to_string(values) +
                             " values: " + std::to_string(channels) +
                             " a pixel are needed, and 1 to 2^28 pixels");
}

void
requireWholeImage(const RgbImage& image)
{
  requireImageValues(image.width, image.height, 3, image.values.size());
}

namespace {

constexpr std::uint64_t max_bytes = std::uint64_t{1} << 31;
constexpr std::size_t kind_bytes = 8; // to distinguish a PNG from a JPEG

/** \brief Reads a file of a supported format and decodes it.
 * \param[in] is_known is called with the first bytes, returns a fault or nullptr */
template <typename Kind, typename Decode>
auto
loadImage(const std::string& path, const Kind& is_known, const Decode& decode)
{
  ByteSource source(path);
  ImageBytes bytes(std::min<std::uint64_t>(kind_bytes, source.remaining()));
  source.read(bytes.data(), bytes.size());
  if (const char* const fault = is_known(bytes))
    source.fail(fault);
  const std::uint64_t rest = source.remaining();
  if (rest > max_bytes)
    source.fail("is too long for an image: " + std::to_string(rest) + " bytes");
  const std::size_t begun = bytes.size();
  bytes.resize(begun + static_cast<std::size_t>(rest));
  if (rest > 0)
    source.read(bytes.data() + begun, static_cast<std::size_t>(rest));
  try {
    return decode(bytes);
  }
  catch (const DamagedImage& fault) {
    source.fail(fault.what());
  }
}

void
saveBytes(const std::string& path, const std::vector<std::uint8_t>& bytes)
{
  OutputFile file(path);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

} // namespace
} // namespace acmap

RgbImage
loadRgbImage(const std::string& path)
{
  return acmap::loadImage(
      path,
      [](const acmap::ImageBytes& begin) {
        return acmap::isPng(begin) || acmap::isJpeg(begin) || acmap::isPnm(begin)
                   ? nullptr
                   : "is no PNG, JPEG, PGM or PPM";
      },
      [](const acmap::ImageBytes& bytes) {
        return acmap::isPng(bytes)    ? acmap::decodePng(bytes)
               : acmap::isJpeg(bytes) ? acmap::decodeJpeg(bytes)
                                      : acmap::decodePnm(bytes);
      });
}

GrayImage16
loadGrayImage16(const std::string& path)
{
  return acmap::loadImage(
      path,
      [](const acmap::ImageBytes& begin) {
        return acmap::isPng(begin) || acmap::isPnm(begin) ? nullptr
                                                          : "is no PNG or PGM";
      },
      [](const acmap::ImageBytes& bytes) {
        return acmap::isPng(bytes) ? acmap::decodeGrayPng(bytes)
                                   : acmap::decodeGrayPnm(bytes);
      });
}

void
savePng(const std::string& path, const RgbImage& image)
{
  acmap::saveBytes(path, encodePng(image));
}

void
savePng(const std::string& path,
        std::int32_t width,
        std::int32_t height,
        const std::vector<std::uint8_t>& values)
{
  acmap::saveBytes(path, encodePng(width, height, values));
}

} // namespace pcl
