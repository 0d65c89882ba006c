#include "pattern/image_fit.h"
#include "pattern/x_connection.h"
#include "pattern/x_pixels.h"

#include <pcl/acquisition/pattern_window.h>

#include <pcl/acquisition/pattern_projector.h>

#include <X11/Xlib.h>

namespace pcl {

namespace {

Cursor
invisibleCursor(Display* display)
{
  const char nothing[] = {0};
  const Pixmap bitmap =
      XCreateBitmapFromData(display, DefaultRootWindow(display), nothing, 1, 1);
  XColor black{};
  const Cursor cursor =
      XCreatePixmapCursor(display, bitmap, bitmap, &black, &black, 0, 0);
  XFreePixmap(display, bitmap);
  return cursor;
}

} // namespace

/** \brief The window and its connection to the server. */
class PatternWindow::Canvas {
public:
  Canvas(std::size_t monitor, const std::string& display)
  : connection_(display)
  , format_(acmap::pixelFormatOf(connection_))
  , monitor_(acmap::chooseMonitor(connection_, monitor))
  {
    connection_.call("opening the window", [this] { open(); });
  }

  const MonitorPlace&
  monitor() const
  {
    return monitor_;
  }

  void
  show(const RgbImage& image)
  {
    const RgbImage picture = acmap::fitImage(image, monitor_.width, monitor_.height);
    connection_.call("showing the pattern", [&] {
      Display* const display = connection_.display();
      const Pixmap pixmap = XCreatePixmap(display,
                                          window_,
                                          static_cast<unsigned>(monitor_.width),
                                          static_cast<unsigned>(monitor_.height),
                                          static_cast<unsigned>(format_.depth));
      acmap::putPicture(display, pixmap, format_, picture);
      // The server redraws a background pixmap itself where the window was covered.
      XSetWindowBackgroundPixmap(display, window_, pixmap);
      XFreePixmap(display, pixmap);
      redraw();
    });
  }

  void
  clear()
  {
    connection_.call("showing black", [this] {
      XSetWindowBackground(connection_.display(), window_, format_.opaque);
      redraw();
    });
  }

private:
  void
  open()
  {
    Display* const display = connection_.display();
    XSetWindowAttributes attributes{};
    attributes.override_redirect = True;
    attributes.background_pixel = format_.opaque;
    attributes.cursor = invisibleCursor(display);
    window_ = XCreateWindow(display,
                            DefaultRootWindow(display),
                            monitor_.x,
                            monitor_.y,
                            static_cast<unsigned>(monitor_.width),
                            static_cast<unsigned>(monitor_.height),
                            0,
                            format_.depth,
                            InputOutput,
                            format_.visual,
                            CWOverrideRedirect | CWBackPixel | CWCursor,
                            &attributes);
    XMapRaised(display, window_);
  }

  void
  redraw()
  {
    XRaiseWindow(connection_.display(), window_);
    XClearWindow(connection_.display(), window_);
  }

  acmap::XConnection connection_;
  acmap::PixelFormat format_;
  MonitorPlace monitor_;
  Window window_ = 0;
};

PatternWindow::PatternWindow(std::size_t monitor, const std::string& display)
: canvas_(std::make_unique<Canvas>(monitor, display))
{}

PatternWindow::~PatternWindow() = default;

std::vector<MonitorPlace>
PatternWindow::monitors(const std::string& display)
{
  acmap::XConnection connection(display);
  return acmap::findMonitors(connection);
}

const MonitorPlace&
PatternWindow::getMonitor() const
{
  return canvas_->monitor();
}

void
PatternWindow::show(const RgbImage& image)
{
  canvas_->show(image);
}

void
PatternWindow::showNothing()
{
  canvas_->clear();
}

PatternProjector::~PatternProjector() = default;

} // namespace pcl
