#pragma once

#include "frame_queue.h"
#include "grab_outputs.h"
#include "live_window.h"
#include "pacing.h"
#include "pattern_need.h"
#include "projection.h"

#include <functional>
#include <optional>

namespace pcl::acmap {

/** \brief Brings frames from the device to the outputs. */
class GrabRun {
public:
  /** \param[in] live null without a window; all outlive it */
  GrabRun(Tool& tool,
          const GrabberOptions& options,
          const Device& device,
          GrabOutputs& outputs,
          StatusLine& status,
          LiveWindow* live);

  /** \brief No callback of a grabber comes any more. */
  ~GrabRun();

  GrabRun(const GrabRun&) = delete;
  GrabRun&
  operator=(const GrabRun&) = delete;

  /** \brief All observations of a recording, or as many as are wanted. */
  void
  passRecording();

  /** \brief Frames of the camera, one after another, until the user's end. */
  void
  passStream();

  /** \brief Observations of camera and projector. */
  void
  passObservations(PatternSequenceGrabber& sequence);

  /** \brief All is done: lets the user look until the window is closed, or an
   * interruption. */
  void
  waitForWindow();

  /** \brief That came so far. */
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
  std::optional<PatternNeed> need_; // where it may end an observation
  FrameQueue queue_;
  TrinocularGrabber* grabber_ = nullptr;
  boost::signals2::connection connection_;
  std::size_t frames_ = 0;
  std::size_t shots_ = 0;  // of the observation that is taken
  std::size_t wanted_ = 0; // observations, 0: all
};

} // namespace pcl::acmap
