#pragma once

#include "x_connection.h"

#include <pcl/core/image_file.h>

#include <X11/Xlib.h>

#include <array>

namespace pcl::acmap {

/** \brief Conversion of colours to pixel values of a visual. */
struct PixelFormat {
  Visual* visual = nullptr;
  int depth = 0;
  std::array<int, 3> shifts{};
  unsigned long opaque = 0; ///< bits that belong to no colour
};

/** \brief The format of the display's default screen.
 * \throws IOException naming the format unless it is direct colour of 8 bits per
 * channel in pixels of depth 24 or 32 */
PixelFormat
pixelFormatOf(const XConnection& connection);

/** \brief Puts a picture into a pixmap of its size and format. */
void
putPicture(Display* display,
           Pixmap pixmap,
           const PixelFormat& format,
           const RgbImage& picture);

} // namespace pcl::acmap
