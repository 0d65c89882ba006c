#pragma once

#include <pcl/acquisition/pattern_projector.h>
#include <pcl/core/trinocular_grabber.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>

namespace pcl::acmap {

/** \brief Shots of a camera under what a projector shows, one at a time. Used by one
 * thread; others may cancel its waits. */
class ShotTaker {
public:
  using Seconds = std::chrono::duration<double>;

  /** \throws BadArgumentException for no camera or no projector */
  ShotTaker(shared_ptr<TrinocularGrabber> camera,
            shared_ptr<PatternProjector> projector);

  const TrinocularGrabber&
  camera() const
  {
    return *camera_;
  }

  /** \param[in] pattern none: black */
  void
  show(const RgbImage* pattern);

  /** \brief Waits until a time has passed since the projector acknowledged.
   * \return false when it was cancelled */
  bool
  settle(Seconds time);

  /** \brief Takes a shot that is exposed after this call.
   * \return none when it was cancelled
   * \throws CameraException when it does not come in time, or the camera streams for
   * others; what the camera throws, and what ended its stream */
  TrinocularFrame::ConstPtr
  shoot(Seconds timeout);

  /** \brief From the projector's acknowledgement to the trigger of the last shot. */
  Seconds
  delay() const
  {
    return triggered_ - shown_;
  }

  /** \brief Stops the camera and shows black; both, whichever throws. */
  void
  finish();

  /** \brief Whether waits are cut short, those under way too. */
  void
  setCancelled(bool is_cancelled);

private:
  using Clock = std::chrono::steady_clock;

  /** \brief Where the camera's thread leaves a frame; it may outlive the taker. */
  struct Inbox {
    std::mutex mutex; // of all below
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
