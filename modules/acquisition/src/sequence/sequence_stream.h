#pragma once

#include "sequence/sequence_progress.h"
#include "sequence/shot_taker.h"

#include <pcl/core/stream_thread.h>

#include <deque>
#include <vector>

namespace pcl::acmap {

/** \brief Takes shots and observations as jobs, in a thread of its own.
 *
 * A request leaves a job and wakes the thread, which does jobs until none is left.
 * Requests from outside come one after another, so none comes while somebody stops. All
 * members may be called from any thread and from callbacks. */
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

  /** \brief Stops. */
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
    bool are_endless = false; // observations, when the queue is empty
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

  std::mutex requests_; // held by requests from outside; never by the thread

  mutable std::mutex mutex_; // of all below
  Settings settings_;
  Jobs jobs_;
  bool is_job_over_ = false; // somebody stopped
  bool is_stopping_ = false; // somebody outside waits in stop
  bool is_new_ = true;       // no job was done since the last stream ended

  StreamThread thread_; // the last one: it uses all others
};

} // namespace pcl::acmap
