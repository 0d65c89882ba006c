#pragma once

#include "light_clock.h"

#include <pcl/core/random.h>
#include <pcl/core/stream_thread.h>
#include <pcl/core/trinocular_grabber.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>

namespace pcl::acmap::test {

/** \brief A camera with rolling shutter that observes a light: after a delay from the
 * trigger, its rows are exposed one after another. Numbers and stamps of its frames
 * are meaningless. */
class ShutterCamera : public TrinocularGrabber {
public:
  static constexpr int width = 16;
  static constexpr int height = 12;

  explicit ShutterCamera(std::shared_ptr<const LightClock> light);

  ~ShutterCamera() noexcept override;

  // May only be changed while the camera is idle.
  Milliseconds delay{1};     ///< from trigger to the first row
  Milliseconds exposure{2};  ///< of one row
  Milliseconds row_time{.1}; ///< from row to row
  double room = 0;           ///< grey levels of daylight
  double noise = 0;          ///< grey levels, standard deviation
  int lit_rows = height;     ///< rows that the projector lights
  int copies = 1;            ///< of each frame that are delivered
  bool gives_frames = true;
  std::function<void()> on_trigger = [] {}; ///< in the caller's thread; may throw
  std::function<void()> on_shot = [] {};    ///< before each frame; may throw

  void
  start() override;

  /** \brief Also aborts an exposure. */
  void
  stop() override;

  void
  trigger() override;

  void
  rewind() override
  {}

  void
  wait() override;

  bool
  isRunning() const override;

  std::string
  getName() const override;

  float
  getFramesPerSecond() const override
  {
    return 0;
  }

  TrinocularRig
  getRig() const override;

  std::exception_ptr
  getError() const override;

  int
  triggers() const
  {
    return triggers_;
  }

private:
  bool
  giveShot();

  bool
  sleep(Milliseconds time);

  TrinocularFrame::Ptr
  expose(Clock::time_point begin);

  const std::shared_ptr<const LightClock> light_;
  boost::signals2::signal<FrameCallback>* const signal_;
  std::atomic<int> triggers_{0};
  Random random_{1};

  std::mutex mutex_;
  std::condition_variable stopped_;
  int stops_ = 0;
  StreamThread stream_; // last member, because it uses all others
};

} // namespace pcl::acmap::test
