#include <pcl/visualization/display_connection.h>

#include <pcl/core/exceptions.h>

#include <X11/Xlib.h>
#include <xcb/xcb.h>

#include <cstdlib>
#include <string>

namespace pcl::acmap {
namespace {

constexpr const char* advice =
    "; on a machine without a screen run the program under 'xvfb-run -a'";

} // namespace

DisplayConnection::DisplayConnection()
{
  const char* const name = std::getenv("DISPLAY");
  if (!name || !*name)
    throw acmap::InitFailed(std::string("no display: DISPLAY is not set") + advice);
  connection_ = xcb_connect(name, nullptr);
  if (isOpen())
    return;
  xcb_disconnect(connection_);
  throw acmap::InitFailed("no display: the X server " + std::string(name) +
                          " does not answer" + advice);
}

DisplayConnection::~DisplayConnection()
{
  xcb_disconnect(connection_);
}

bool
DisplayConnection::isOpen() const
{
  if (xcb_connection_has_error(connection_))
    return false;
  // the end of a connection is noticed when something is read from it
  std::free(xcb_poll_for_event(connection_));
  return !xcb_connection_has_error(connection_);
}

void
DisplayConnection::surviveLossOf(void* display)
{
  // both the usual handler and what is called after it end the process
  XSetIOErrorHandler([](Display*) { return 0; });
  XSetIOErrorExitHandler(
      static_cast<Display*>(display), [](Display*, void*) {}, nullptr);
}

} // namespace pcl::acmap
