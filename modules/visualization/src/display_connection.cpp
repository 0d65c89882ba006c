#include <pcl/visualization/display_connection.h>

#include <pcl/exceptions.h>

#include <X11/Xlib.h>

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
    throw InitFailedException(std::string("no display: DISPLAY is not set") + advice);
  display_ = XOpenDisplay(name);
  if (!display_)
    throw InitFailedException("no display: the X server " + std::string(name) +
                              " does not answer" + advice);
}

DisplayConnection::~DisplayConnection()
{
  XCloseDisplay(static_cast<Display*>(display_));
}

} // namespace pcl::acmap
