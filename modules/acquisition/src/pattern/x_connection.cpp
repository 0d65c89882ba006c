#include "x_connection.h"

#include <pcl/core/exceptions.h>
#include <pcl/exceptions.h>

#include <X11/Xlib.h>
#include <X11/extensions/Xrandr.h>

namespace pcl::acmap {

namespace {

thread_local int error_code = Success;

int
keepError(Display*, XErrorEvent* error)
{
  if (error_code == Success) // later errors result from the first one
    error_code = error->error_code;
  return 0;
}

int
keepQuiet(Display*)
{
  return 0;
}

/** \brief Xlib's error handlers are global to the process; ours are installed during a
 * call. */
class ErrorTrap {
public:
  ErrorTrap()
  : errors_(XSetErrorHandler(keepError))
  , losses_(XSetIOErrorHandler(keepQuiet))
  {
    error_code = Success;
  }

  ~ErrorTrap()
  {
    XSetErrorHandler(errors_);
    XSetIOErrorHandler(losses_);
  }

  ErrorTrap(const ErrorTrap&) = delete;
  ErrorTrap&
  operator=(const ErrorTrap&) = delete;

private:
  XErrorHandler errors_;
  XIOErrorHandler losses_;
};

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

XConnection::XConnection(const std::string& name)
: name_(XDisplayName(name.empty() ? nullptr : name.c_str()))
, display_(XOpenDisplay(name.empty() ? nullptr : name.c_str()))
{
  if (!display_)
    throw acmap::IoFault(name_.empty() ? "there is no display: DISPLAY is not set"
                                       : "display " + name_ + " cannot be opened");
  // Set a flag where Xlib would end the process.
  XSetIOErrorExitHandler(
      display_,
      [](Display*, void* is_lost) { *static_cast<bool*>(is_lost) = true; },
      &is_lost_);
}

XConnection::~XConnection()
{
  const ErrorTrap trap;
  XCloseDisplay(display_);
}

void
XConnection::call(const std::string& doing, const std::function<void()>& requests)
{
  const ErrorTrap trap;
  if (!is_lost_) {
    requests();
    XSync(display_, False);
  }
  if (is_lost_)
    fail("the X server is gone");
  if (error_code == Success)
    return;
  char text[256] = "";
  XGetErrorText(display_, error_code, text, sizeof(text));
  fail(doing + " failed: " + text);
}

void
XConnection::fail(const std::string& reason) const
{
  throw acmap::IoFault("display " + name_ + ": " + reason);
}

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
    throw acmap::BadArgument(
        "monitor = " + std::to_string(index) + " is refused: the display has " +
        std::to_string(places.size()) + ", and counting begins with 0");
  return places[index];
}

} // namespace pcl::acmap
