#pragma once

#include "sequence/sequence_progress.h"
#include "sequence/shot_taker.h"

#include <pcl/core/stream_thread.h>

#include <deque>
#include <vector>

namespace pcl::acmap {

/** \brief Takes shots and observations as jobs in a thread of its own.
 *
 * A request adds a job and wakes the thread, which executes jobs until none is left.
 * Requests from outside the thread are serialized, so that none is added during a stop.
 * All functions may be called from any thread and from callbacks. */
class SequenceStream {
public:
  using Signal = boost::signals2::signal<TrinocularGrabber::FrameCallback>;
  using WantMore = PatternSequenceGrabber::WantMore;
  using Seconds = ShotTaker::Seconds;

  struct Settings {
    Seconds settle_time{0.1};
    Seconds shot_timeout{5};
    WantMore want_more;
  };

  SequenceStream(shared_ptr<TrinocularGrabber> camera,
                 shared_ptr<PatternProjector> projector,
                 std::vector<RgbImage> patterns,
                 const Signal& signal);

  /** \brief Stops the thread. */
  ~SequenceStream();

  Settings
  settings() const;

  void
  setSettings(const std::function<void(Settings&)>& change);

  void
  addShot();

  void
  addObservation();

  void
  addObservationsWithoutEnd();

  void
  stop();

  SequenceProgress&
  progress()
  {
    return progress_;
  }

  const TrinocularGrabber&
  camera() const
  {
    return taker_.camera();
  }

  StreamThread&
  thread()
  {
    return thread_;
  }

private:
  using Shot = SequenceProgress::Shot;

  enum class Job { Shot, Observation };

  struct Jobs {
    std::deque<Job> queue;
    bool are_endless = false; // repeat observations when the queue is empty
  };

  void
  request(const std::function<void(Jobs&)>& add);

  void
  dropJobs();

  std::optional<Job>
  nextJob();

  bool
  isJobOver() const;

  bool
  doJobs();

  bool
  finishesObservation();

  TrinocularFrame::ConstPtr
  take(const Shot& shot, const Settings& current);

  bool
  needsMore(const Shot& shot,
            const TrinocularFrame& frame,
            const WantMore& want_more) const;

  void
  end();

  const std::vector<RgbImage> patterns_;
  const Signal& signal_;
  ShotTaker taker_;
  SequenceProgress progress_;

  std::mutex requests_; // locked by requests from outside; never by the thread

  mutable std::mutex mutex_; // protects the members below
  Settings settings_;
  Jobs jobs_;
  bool is_job_over_ = false; // the current job was cancelled
  bool is_stopping_ = false; // another thread is waiting in stop
  bool is_new_ = true;       // no job was executed since the end of the last stream

  StreamThread thread_; // declared last, since its thread uses all other members
};

} // namespace pcl::acmap
