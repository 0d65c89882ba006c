#pragma once

#include <pcl/core/image_file.h>

namespace pcl::acmap {

/** \brief Returns true if an image has at least one pixel, and all its values. */
bool
isWhole(const RgbImage& image);

/** \brief Position and size of an image on a monitor, in pixels. */
struct ImagePlace {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/** \brief The largest centred rectangle with the image's aspect ratio on the
 * monitor. */
ImagePlace
placeOf(const RgbImage& image, int monitor_width, int monitor_height);

/** \brief The content of a monitor: the image at its place on black. Each pixel has the
 * colour of the image's pixel at its centre.
 * \throws BadArgumentException when the image is empty or incomplete */
RgbImage
fitImage(const RgbImage& image, int monitor_width, int monitor_height);

} // namespace pcl::acmap
