#pragma once

#include "grabber/observation_maker.h"

#include <pcl/core/stream_thread.h>

#include <array>
#include <memory>
#include <mutex>
#include <thread>

namespace pcl::acmap {

/** \brief Runs a grabber of frames and makes observations of what it gives. What it is asked
 * may be asked from any thread and from callbacks.
 *
 * Two threads: that of the frame grabber, in which frames are taken, and one of its own,
 * which starts it, waits for its end, and then finishes. Both never work at once. */
class ObservationStream {
public:
  ObservationStream(shared_ptr<TrinocularGrabber> frames, ObservationMaker::Give give);

  /** \brief Stops. */
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
  /** \brief Where frames come in, as long as the stream is there. */
  struct Entrance {
    std::mutex mutex;
    ObservationStream* stream = nullptr;
  };

  enum class Wish {
    Stream,
    Pause,   ///< a callback said stop
    Restart, ///< and then start
    Stop     ///< somebody outside said stop, and waits
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
  bool is_restarted_ = false; // of the own thread

  std::mutex lifecycle_; // held by who starts or stops from outside; never by callbacks

  mutable std::mutex mutex_; // of all below
  Wish wish_ = Wish::Stream;
  bool takes_frames_ = false;
  std::thread::id own_thread_;
  std::thread::id frame_thread_;

  const std::shared_ptr<Entrance> entrance_;
  boost::signals2::scoped_connection connection_;
  StreamThread thread_; // the last one: it uses all others
};

} // namespace pcl::acmap
