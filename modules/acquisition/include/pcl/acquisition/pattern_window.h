#pragma once

#include <pcl/acquisition/pattern_projector.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief Position and size of a monitor on the screen of the X server, in pixels.
 * \ingroup acquisition */
struct MonitorPlace {
  std::string name; ///< name of the output, for example HDMI-1
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  bool is_primary = false;
};

/** \brief A projector that is connected as a monitor of an X server. A black window
 * without border and cursor covers the whole monitor; it is above all other windows,
 * and window managers do not move it.
 *
 * An image of the monitor's size is shown pixel by pixel. Any other image is scaled,
 * without interpolation, to the largest size that fits and keeps its aspect ratio, and
 * is centred on black. Therefore patterns should have the projector's own size.
 *
 * \ref show returns when the X server has drawn the image. The projector displays it
 * with its next refresh; a compositor adds one refresh. Wait for two or three refresh
 * periods (50 ms) before the shot.
 *
 * The window ignores keys and needs no event loop, since the server keeps the image.
 * While a method runs, errors of the X server are caught by a handler of the whole
 * process, so no other thread may use Xlib during this time. The class must not be used
 * by two threads at once. Users have to disable screen blanking themselves.
 * \code
 * pcl::PatternWindow projector (1);
 * projector.show (pattern.generate (0));
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT PatternWindow : public PatternProjector {
public:
  /** \brief Opens a black window.
   * \param[in] monitor index in \ref monitors
   * \param[in] display name of the X server, for example :0; if empty, the environment
   * variable DISPLAY is used
   * \throws BadArgumentException when there is no such monitor
   * \throws IOException when there is no such display, when it fails, or when it has
   * neither 24 nor 32 bits per pixel of direct colour */
  explicit PatternWindow(std::size_t monitor, const std::string& display = {});

  ~PatternWindow() override;

  /** \brief Returns the active monitors in the order of the X server; if the server
   * cannot list them, the whole screen is returned as one monitor.
   * \throws IOException when there is no such display or it fails */
  static std::vector<MonitorPlace>
  monitors(const std::string& display = {});

  /** \brief The monitor that is covered. */
  const MonitorPlace&
  getMonitor() const;

  void
  show(const RgbImage& image) override;

  void
  showNothing() override;

private:
  class Canvas;
  std::unique_ptr<Canvas> canvas_;
};

} // namespace pcl
