#pragma once

#include <pcl/core/image_file.h>

namespace pcl::acmap {

/** \brief Whether an image has at least a pixel, and all its values. */
bool
isWhole(const RgbImage& image);

/** \brief Where an image lies on a monitor, pixels. */
struct ImagePlace {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/** \brief The largest place of the image's shape on the monitor, in its middle. */
ImagePlace
placeOf(const RgbImage& image, int monitor_width, int monitor_height);

/** \brief A monitor's picture: the image in its place on black. A pixel takes the colour
 * of the image's pixel under its centre.
 * \throws BadArgumentException when the image is empty or has not all its values */
RgbImage
fitImage(const RgbImage& image, int monitor_width, int monitor_height);

} // namespace pcl::acmap
