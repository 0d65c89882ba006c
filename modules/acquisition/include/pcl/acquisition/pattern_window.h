#pragma once

#include <pcl/acquisition/pattern_projector.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief Where a monitor's picture lies on the screen of the X server, in pixels.
 * \ingroup acquisition */
struct MonitorPlace {
  std::string name; ///< of the output, say HDMI-1
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  bool is_primary = false;
};

/** \brief A projector that is a monitor of an X server: a black window over all of it,
 * without border and cursor, above all others, which no window manager moves.
 *
 * An image of the monitor's size is shown pixel by pixel. Any other is scaled, without
 * mixing pixels, to the largest size of its shape that fits, in the middle of black: so
 * make patterns of the projector's own size.
 *
 * \ref show returns when the X server has drawn the image. The projector itself shows it
 * with its next picture, a compositor one later: wait for two or three (50 ms) before the
 * shot.
 *
 * The window answers no key and needs no event loop: the server keeps the picture. Errors
 * of the X server are caught while a method runs, by a handler of the whole process: no
 * other thread may use Xlib then. Not for use by two threads at once. Blanking of the
 * screen is for the user to switch off.
 * \code
 * pcl::PatternWindow projector (1);
 * projector.show (pattern.generate (0));
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT PatternWindow : public PatternProjector {
public:
  /** \brief Opens the window, black.
   * \param[in] monitor index in \ref monitors
   * \param[in] display name of the X server, say :0; empty: the environment's DISPLAY
   * \throws BadArgumentException when there is no such monitor
   * \throws IOException when there is no such display, it fails, or it has neither 24
   * nor 32 bits a pixel of direct colour */
  explicit PatternWindow(std::size_t monitor, const std::string& display = {});

  ~PatternWindow() override;

  /** \brief The monitors in use, in the order of the X server; all of the screen as one
   * where it cannot tell.
   * \throws IOException when there is no such display or it fails */
  static std::vector<MonitorPlace>
  monitors(const std::string& display = {});

  /** \brief The one that is covered. */
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
