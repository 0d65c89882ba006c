#include "checks.h"
#include "images/image_codecs.h"

using namespace pcl::acmap;

namespace {

/** \brief Decodes an image; returns nothing if the bytes are invalid. */
template <typename Image>
std::optional<Image>
decoded(Image (*decode)(const ImageBytes&),
        const ImageBytes& bytes,
        std::size_t channels)
{
  try {
    const Image image = decode(bytes);
    test::require(image.width > 0 && image.height > 0);
    test::require(image.values.size() == channels *
                                             static_cast<std::size_t>(image.width) *
                                             static_cast<std::size_t>(image.height));
    return image;
  }
  catch (const DamagedImage& fault) {
    test::require(*fault.what() != '\0');
    return std::nullopt;
  }
}

} // namespace

/** Bytes are rejected, or give an image that is unchanged by writing and reading a
 * PNG. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const ImageBytes bytes(data, data + size);
  std::optional<pcl::RgbImage> image;
  if (isPng(bytes)) {
    image = decoded(&decodePng, bytes, 3);
    decoded(&decodeGrayPng, bytes, 1);
  }
  else if (isJpeg(bytes))
    image = decoded(&decodeJpeg, bytes, 3);
  else if (isPnm(bytes)) {
    image = decoded(&decodePnm, bytes, 3);
    decoded(&decodeGrayPnm, bytes, 1);
  }
  constexpr std::size_t few = 3000; // compression takes longer than reading
  if (!image || image->values.size() > few)
    return 0;
  const pcl::RgbImage again = decodePng(pcl::encodePng(*image));
  test::require(again.width == image->width && again.height == image->height &&
                again.values == image->values);
  return 0;
}
