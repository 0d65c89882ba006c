#pragma once

#include "device.h"
#include "status_line.h"

#include <pcl/acquisition/pattern_sequence_grabber.h>
#include <pcl/acquisition/pattern_window.h>

#include <memory>
#include <mutex>

namespace pcl::acmap {

/** \brief A projector's monitor, which is used only while no other thread draws, since
 * Xlib is not thread-safe. */
class GuardedWindow : public PatternProjector {
public:
  /** \param[in] drawing is locked during drawing; outlives the window */
  GuardedWindow(std::mutex& drawing, std::size_t monitor, const std::string& display);

  const MonitorPlace&
  getMonitor() const
  {
    return window_.getMonitor();
  }

  void
  show(const RgbImage& image) override;

  void
  showNothing() override;

private:
  std::mutex& drawing_;
  PatternWindow window_;
};

/** \brief The projector with its patterns, and the grabber that synchronises the camera
 * with it. */
struct Projection {
  shared_ptr<GuardedWindow> window;
  shared_ptr<PatternSequenceGrabber> sequence;
};

/** \brief Opens the projector, draws the patterns, and measures the order of the
 * channels and the settle time if they are unknown.
 * \throws BadArgumentException, IOException as \ref PatternWindow
 * \throws MemoryRefused when the patterns do not fit
 * \throws CameraException when a shot fails
 * \throws CancelledException when the user interrupted it */
Projection
openProjection(Tool& tool,
               const GrabberOptions& options,
               const Device& device,
               std::mutex& drawing,
               StatusLine& status);

} // namespace pcl::acmap
