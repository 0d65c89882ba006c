#pragma once

#include "device.h"
#include "terminal.h"

#include <pcl/acquisition/pattern_sequence_grabber.h>
#include <pcl/acquisition/pattern_window.h>

#include <mutex>

namespace pcl::acmap {

/** \brief The projector, and the grabber that synchronises the camera with it. */
struct Projection {
  MonitorPlace monitor;
  shared_ptr<PatternSequenceGrabber> sequence;
};

/** \brief Opens the projector, draws the patterns, and measures the order of the
 * channels and the settle time if they are unknown.
 * \param[in] drawing is locked while the projector's window is drawn, since Xlib is not
 * thread-safe; outlives the projection
 * \throws BadArgumentException, IOException as \ref PatternWindow
 * \throws MemoryRefused when the patterns do not fit
 * \throws CameraException when a shot fails
 * \throws CancelledException when the user interrupted it */
Projection
openProjection(const GrabberOptions& options,
               const Device& device,
               std::mutex& drawing,
               StatusLine& status,
               StageLog& log);

} // namespace pcl::acmap
