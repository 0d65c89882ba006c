#pragma once

#include "device.h"
#include "frame_queue.h"
#include "grab_outputs.h"
#include "live_window.h"
#include "pacing.h"
#include "pattern_need.h"
#include "projection.h"

#include <functional>
#include <optional>

namespace pcl::acmap {

/** \brief Moves frames from the device to the outputs. */
class GrabRun {
public:
  /** \param[in] live null without a window; all arguments outlive this object */
  GrabRun(Tool& tool,
          const GrabberOptions& options,
          const Device& device,
          GrabOutputs& outputs,
          StatusLine& status,
          LiveWindow* live);

  /** \brief Afterwards no callback of a grabber is called. */
  ~GrabRun();

  GrabRun(const GrabRun&) = delete;
  GrabRun&
  operator=(const GrabRun&) = delete;

  /** \brief Processes all observations of a recording, or the requested number. */
  void
  passRecording();

  /** \brief Processes frames of the camera, one after another, until the user ends
   * it. */
  void
  passStream();

  /** \brief Processes observations of camera and projector. */
  void
  passObservations(PatternSequenceGrabber& sequence);

  /** \brief After the work: shows the window until it is closed, or until an
   * interruption. */
  void
  waitForWindow();

  /** \brief Number of received frames. */
  std::size_t
  frames() const
  {
    return frames_;
  }

private:
  /** \return false to end the stream */
  using UseFrame = std::function<bool(const TrinocularFrame::ConstPtr& frame)>;

  void
  listenTo(TrinocularGrabber& grabber);

  void
  end();

  void
  pump(const UseFrame& use, const std::function<bool()>& is_over);

  void
  pumpAll(const UseFrame& use);

  void
  idle();

  ProgressCallback
  progress();

  void
  tellStatus(const std::string& step);

  std::string
  doing() const;

  Tool& tool_;
  const GrabberOptions& options_;
  const Device& device_;
  GrabOutputs& outputs_;
  StatusLine& status_;
  LiveWindow* live_;
  std::optional<PatternNeed> need_; // set if observations may end early
  FrameQueue queue_;
  TrinocularGrabber* grabber_ = nullptr;
  boost::signals2::connection connection_;
  std::size_t frames_ = 0;
  std::size_t shots_ = 0;  // of the current observation
  std::size_t wanted_ = 0; // number of observations, 0: all
};

/** \brief Writes lines of summary and report about device and projector.
 * \param[in] projection null if there is none
 * \param[in] frames number of received frames */
void
tellDevice(Tool& tool,
           const GrabberOptions& options,
           const Device& device,
           const Projection* projection,
           std::size_t frames);

} // namespace pcl::acmap
