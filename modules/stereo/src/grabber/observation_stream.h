#pragma once

#include "grabber/observation_maker.h"

#include <pcl/core/stream_thread.h>

#include <array>
#include <memory>
#include <mutex>
#include <thread>

namespace pcl::acmap {

/** \brief Runs a grabber of frames and computes observations from its frames. The
 * public functions may be called from any thread and from callbacks.
 *
 * There are two threads: that of the frame grabber, in which frames are received, and
 * an own thread, which starts the frame grabber, waits for its end, and then finishes.
 * They never work at the same time. */
class ObservationStream {
public:
  ObservationStream(shared_ptr<TrinocularGrabber> frames, ObservationMaker::Give give);

  /** \brief Stops the stream. */
  ~ObservationStream();

  void
  start();

  void
  stop();

  void
  wait();

  bool
  isRunning() const
  {
    return thread_.isRunning();
  }

  std::exception_ptr
  error() const
  {
    return thread_.error();
  }

  ObservationMaker&
  maker()
  {
    return maker_;
  }

  const TrinocularGrabber&
  frames() const
  {
    return *frames_;
  }

private:
  /** \brief Entry point for frames; it has no stream after the stream is destroyed. */
  struct Entrance {
    std::mutex mutex;
    ObservationStream* stream = nullptr;
  };

  enum class Wish {
    Stream,
    Pause,   ///< a callback called stop
    Restart, ///< a callback called stop and then start
    Stop     ///< other code called stop and waits
  };

  bool
  isWithin() const;

  void
  takeIfStreaming(const TrinocularFrame::ConstPtr& frame);

  bool
  run();

  bool
  streamFrames();

  void
  finish();

  const shared_ptr<TrinocularGrabber> frames_;
  ObservationMaker maker_;
  bool is_restarted_ = false; // only used by the own thread

  std::mutex lifecycle_; // for start and stop from outside; never locked by callbacks

  mutable std::mutex mutex_; // protects all members below
  Wish wish_ = Wish::Stream;
  bool takes_frames_ = false;
  std::thread::id own_thread_;
  std::thread::id frame_thread_;

  const std::shared_ptr<Entrance> entrance_;
  boost::signals2::scoped_connection connection_;
  StreamThread thread_; // must be the last member, because it uses all others
};

} // namespace pcl::acmap
