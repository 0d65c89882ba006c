#include "x_monitors.h"

#include <pcl/core/exceptions.h>

#include <X11/Xlib.h>
#include <X11/extensions/Xrandr.h>

namespace pcl::acmap {
namespace {

std::string
nameOf(Display* display, Atom atom)
{
  char* const text = XGetAtomName(display, atom);
  const std::string name = text ? text : "";
  XFree(text);
  return name;
}

bool
tellsMonitors(Display* display)
{
  int first_event = 0;
  int first_error = 0;
  int major = 0;
  int minor = 0;
  return XRRQueryExtension(display, &first_event, &first_error) &&
         XRRQueryVersion(display, &major, &minor) &&
         (major > 1 || (major == 1 && minor >= 5));
}

} // namespace

std::vector<MonitorPlace>
findMonitors(XConnection& connection)
{
  Display* const display = connection.display();
  std::vector<MonitorPlace> places;
  connection.call("asking for monitors", [&] {
    if (!tellsMonitors(display))
      return;
    int count = 0;
    XRRMonitorInfo* const found =
        XRRGetMonitors(display, DefaultRootWindow(display), True, &count);
    if (!found)
      return;
    for (const XRRMonitorInfo* m = found; m < found + count; ++m)
      places.push_back(
          {nameOf(display, m->name), m->x, m->y, m->width, m->height, m->primary != 0});
    XRRFreeMonitors(found);
  });
  if (places.empty()) {
    const int screen = DefaultScreen(display);
    places.push_back({"screen",
                      0,
                      0,
                      DisplayWidth(display, screen),
                      DisplayHeight(display, screen),
                      true});
  }
  return places;
}

MonitorPlace
chooseMonitor(XConnection& connection, std::size_t index)
{
  const std::vector<MonitorPlace> places = findMonitors(connection);
  if (index >= places.size())
    throw BadArgumentException(
        "monitor = " + std::to_string(index) + " is refused: the display has " +
        std::to_string(places.size()) + ", and counting begins with 0");
  return places[index];
}

} // namespace pcl::acmap
