#include "image_fit.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>

#include <algorithm>

namespace pcl::acmap {
namespace {

void
requireWhole(const RgbImage& image)
{
  if (!isWhole(image))
    throw acmap::BadArgument("an image of " + sizeText(image) + " px with " +
                             std::to_string(image.values.size()) +
                             " values cannot be shown: it must have three a pixel, "
                             "and at least one pixel");
}

/** a b / c, rounded to the nearest integer, at least 1. */
int
scaledLength(std::int64_t a, std::int64_t b, std::int64_t c)
{
  return static_cast<int>(std::max<std::int64_t>(1, (2 * a * b + c) / (2 * c)));
}

/** Index of the pixel in a row of m pixels that is at the centre of pixel i in a row of
 * n. */
std::int32_t
pixelUnder(std::int64_t i, std::int64_t n, std::int64_t m)
{
  return static_cast<std::int32_t>((2 * i + 1) * m / (2 * n));
}

} // namespace

bool
isWhole(const RgbImage& image)
{
  return image.width > 0 && image.height > 0 &&
         image.values.size() == 3 * static_cast<std::size_t>(image.width) *
                                    static_cast<std::size_t>(image.height);
}

ImagePlace
placeOf(const RgbImage& image, int monitor_width, int monitor_height)
{
  ImagePlace place;
  const bool is_wider = std::int64_t{image.width} * monitor_height >=
                        std::int64_t{image.height} * monitor_width;
  place.width = is_wider ? monitor_width
                         : scaledLength(image.width, monitor_height, image.height);
  place.height = is_wider ? scaledLength(image.height, monitor_width, image.width)
                          : monitor_height;
  place.x = (monitor_width - place.width) / 2;
  place.y = (monitor_height - place.height) / 2;
  return place;
}

RgbImage
fitImage(const RgbImage& image, int monitor_width, int monitor_height)
{
  requireWhole(image);
  const ImagePlace place = placeOf(image, monitor_width, monitor_height);
  RgbImage picture{monitor_width, monitor_height, {}};
  picture.values.resize(3 * static_cast<std::size_t>(monitor_width) *
                        static_cast<std::size_t>(monitor_height));
  for (int row = 0; row < place.height; ++row)
    for (int column = 0; column < place.width; ++column)
      std::copy_n(image.at(pixelUnder(column, place.width, image.width),
                           pixelUnder(row, place.height, image.height)),
                  3,
                  picture.at(place.x + column, place.y + row));
  return picture;
}

} // namespace pcl::acmap
