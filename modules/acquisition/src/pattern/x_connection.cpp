#include "x_connection.h"

#include <pcl/exceptions.h>

#include <X11/Xlib.h>

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

} // namespace

XConnection::XConnection(const std::string& name)
: name_(XDisplayName(name.empty() ? nullptr : name.c_str()))
, display_(XOpenDisplay(name.empty() ? nullptr : name.c_str()))
{
  if (!display_)
    throw IOException(name_.empty() ? "there is no display: DISPLAY is not set"
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
  throw IOException("display " + name_ + ": " + reason);
}

} // namespace pcl::acmap
