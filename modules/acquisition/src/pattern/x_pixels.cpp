#include "x_pixels.h"

#include <pcl/core/exceptions.h>

#include <X11/Xutil.h>

#include <vector>

namespace pcl::acmap {
namespace {

unsigned long
pixelOf(const std::uint8_t* color, const PixelFormat& format)
{
  unsigned long pixel = format.opaque;
  for (std::size_t channel = 0; channel < 3; ++channel)
    pixel |= static_cast<unsigned long>(color[channel]) << format.shifts[channel];
  return pixel;
}

} // namespace

PixelFormat
pixelFormatOf(const XConnection& connection)
{
  Display* const display = connection.display();
  const int screen = DefaultScreen(display);
  PixelFormat format{
      DefaultVisual(display, screen), DefaultDepth(display, screen), {}, 0};
  const unsigned long masks[] = {
      format.visual->red_mask, format.visual->green_mask, format.visual->blue_mask};
  bool is_known =
      format.visual->c_class == TrueColor && (format.depth == 24 || format.depth == 32);
  for (std::size_t channel = 0; is_known && channel < 3; ++channel) {
    while (format.shifts[channel] < 24 &&
           !(masks[channel] >> format.shifts[channel] & 1))
      ++format.shifts[channel];
    is_known = masks[channel] == 0xfful << format.shifts[channel];
  }
  if (!is_known)
    connection.fail("its screen has a visual of depth " + std::to_string(format.depth) +
                    " (class " + std::to_string(format.visual->c_class) +
                    "); patterns need TrueColor of depth 24 or 32, 8 bits a channel");
  if (format.depth == 32)
    format.opaque = 0xfffffffful & ~(masks[0] | masks[1] | masks[2]);
  return format;
}

void
putPicture(Display* display,
           Pixmap pixmap,
           const PixelFormat& format,
           const RgbImage& picture)
{
  XImage* const image = XCreateImage(display,
                                     format.visual,
                                     static_cast<unsigned>(format.depth),
                                     ZPixmap,
                                     0,
                                     nullptr,
                                     static_cast<unsigned>(picture.width),
                                     static_cast<unsigned>(picture.height),
                                     32,
                                     0);
  if (!image)
    throw acmap::IoFault("the X server's pixels are of an unknown form");
  std::vector<char> bytes(static_cast<std::size_t>(image->bytes_per_line) *
                          static_cast<std::size_t>(picture.height));
  image->data = bytes.data();
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column)
      XPutPixel(image, column, row, pixelOf(picture.at(column, row), format));
  const GC context = XCreateGC(display, pixmap, 0, nullptr);
  XPutImage(display,
            pixmap,
            context,
            image,
            0,
            0,
            0,
            0,
            static_cast<unsigned>(picture.width),
            static_cast<unsigned>(picture.height));
  XFreeGC(display, context);
  image->data = nullptr; // the memory belongs to the vector
  XDestroyImage(image);
}

} // namespace pcl::acmap
