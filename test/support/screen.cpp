#include "screen.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/Xrandr.h>

#include <memory>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

using Connection = std::unique_ptr<Display, int (*)(Display*)>;

Connection
connect()
{
  Connection connection(XOpenDisplay(nullptr), XCloseDisplay);
  if (!connection)
    throw std::runtime_error("no display");
  return connection;
}

} // namespace

RgbImage
shootScreen()
{
  const Connection connection = connect();
  Display* const display = connection.get();
  const int screen = DefaultScreen(display);
  RgbImage picture{DisplayWidth(display, screen), DisplayHeight(display, screen), {}};
  XImage* const image = XGetImage(display,
                                  DefaultRootWindow(display),
                                  0,
                                  0,
                                  static_cast<unsigned>(picture.width),
                                  static_cast<unsigned>(picture.height),
                                  AllPlanes,
                                  ZPixmap);
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column) {
      const unsigned long pixel = XGetPixel(image, column, row);
      for (const int shift : {16, 8, 0}) // Xvfb's order
        picture.values.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  XDestroyImage(image);
  return picture;
}

void
divideScreen(const std::vector<MonitorPlace>& monitors)
{
  const Connection connection = connect();
  Display* const display = connection.get();
  XRRScreenResources* const resources =
      XRRGetScreenResources(display, DefaultRootWindow(display));
  bool is_first = true;
  for (const MonitorPlace& place : monitors) {
    XRRMonitorInfo* const monitor =
        XRRAllocateMonitor(display, is_first && resources->noutput > 0 ? 1 : 0);
    if (monitor->noutput == 1)
      monitor->outputs[0] = resources->outputs[0];
    is_first = false;
    monitor->name = XInternAtom(display, place.name.c_str(), False);
    monitor->primary = place.is_primary ? True : False;
    monitor->x = place.x;
    monitor->y = place.y;
    monitor->width = place.width;
    monitor->height = place.height;
    monitor->mwidth = place.width / 4; // millimetres, not used
    monitor->mheight = place.height / 4;
    XRRSetMonitor(display, DefaultRootWindow(display), monitor);
    XRRFreeMonitors(monitor);
  }
  XRRFreeScreenResources(resources);
  XSync(display, False);
}

} // namespace pcl::acmap::test
