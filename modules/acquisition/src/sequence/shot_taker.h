#pragma once

#include <pcl/acquisition/pattern_projector.h>
#include <pcl/core/trinocular_grabber.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>

namespace pcl::acmap {

/** \brief Takes single shots of a camera while a projector shows a pattern. To be used
 * by one thread; other threads may cancel its waits. */
class ShotTaker {
public:
  using Seconds = std::chrono::duration<double>;

  /** \throws BadArgumentException if there is no camera or no projector */
  ShotTaker(shared_ptr<TrinocularGrabber> camera,
            shared_ptr<PatternProjector> projector);

  const TrinocularGrabber&
  camera() const
  {
    return *camera_;
  }

  /** \brief Shows a pattern. \param[in] pattern null: black */
  void
  show(const RgbImage* pattern);

  /** \brief Waits until this time has passed since the projector's acknowledgement.
   * \return false when it was cancelled */
  bool
  settle(Seconds time);

  /** \brief Takes a shot that is exposed after this call.
   * \return null when it was cancelled
   * \throws CameraException when the shot does not arrive in time, or the camera
   * streams for others; also exceptions of the camera, and errors that ended its
   * stream */
  TrinocularFrame::ConstPtr
  shoot(Seconds timeout);

  /** \brief Time from the projector's acknowledgement to the trigger of the last
   * shot. */
  Seconds
  delay() const
  {
    return triggered_ - shown_;
  }

  /** \brief Stops the camera and shows black, even if the camera throws. */
  void
  finish();

  /** \brief Sets whether waits are cancelled, including a current wait. */
  void
  setCancelled(bool is_cancelled);

private:
  using Clock = std::chrono::steady_clock;

  /** \brief Receives a frame from the camera's thread; it may outlive the ShotTaker. */
  struct Inbox {
    std::mutex mutex; // protects the members below
    std::condition_variable changed;
    bool is_cancelled = false;
    TrinocularFrame::ConstPtr frame; // the first one since the last trigger
  };

  bool
  sleepUntil(Clock::time_point end);

  bool
  waitForRest(Clock::time_point deadline);

  void
  throwFaultOfCamera() const;

  const shared_ptr<TrinocularGrabber> camera_;
  const shared_ptr<PatternProjector> projector_;
  const std::shared_ptr<Inbox> inbox_ = std::make_shared<Inbox>();
  Clock::time_point shown_;
  Clock::time_point triggered_;
  boost::signals2::scoped_connection connection_;
};

} // namespace pcl::acmap
