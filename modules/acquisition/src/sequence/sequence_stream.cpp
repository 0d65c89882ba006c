#include "sequence/sequence_stream.h"

#include <utility>

namespace pcl::acmap {

SequenceStream::SequenceStream(shared_ptr<TrinocularGrabber> camera,
                               shared_ptr<PatternProjector> projector,
                               std::vector<RgbImage> patterns,
                               const Signal& signal)
: patterns_(std::move(patterns))
, signal_(signal)
, taker_(std::move(camera), std::move(projector))
, progress_(patterns_.size())
, thread_([this] { return doJobs(); }, {}, [this] { end(); })
{}

SequenceStream::~SequenceStream()
{
  stop();
}

SequenceStream::Settings
SequenceStream::settings() const
{
  const std::lock_guard lock(mutex_);
  return settings_;
}

void
SequenceStream::setSettings(const std::function<void(Settings&)>& change)
{
  const std::lock_guard lock(mutex_);
  change(settings_);
}

void
SequenceStream::addShot()
{
  request([](Jobs& jobs) { jobs.queue.push_back(Job::Shot); });
}

void
SequenceStream::addObservation()
{
  request([](Jobs& jobs) { jobs.queue.push_back(Job::Observation); });
}

void
SequenceStream::addObservationsWithoutEnd()
{
  request([](Jobs& jobs) { jobs.are_endless = true; });
}

void
SequenceStream::request(const std::function<void(Jobs&)>& add)
{
  std::unique_lock requests(requests_, std::defer_lock);
  if (!thread_.isWithin())
    requests.lock();
  {
    const std::lock_guard lock(mutex_);
    // A callback makes a request while another thread is stopping, or an endless stream
    // includes the request.
    if (is_stopping_ || jobs_.are_endless)
      return;
    add(jobs_);
  }
  try {
    thread_.add(1);
  }
  catch (...) { // the system cannot create a thread
    dropJobs();
    throw;
  }
}

void
SequenceStream::stop()
{
  if (thread_.isWithin()) {
    dropJobs();
    progress_.cutOff();
    return;
  }
  const std::lock_guard requests(requests_);
  const auto setStopping = [this](bool is_stopping) {
    const std::lock_guard lock(mutex_);
    is_stopping_ = is_stopping;
  };
  setStopping(true);
  dropJobs();
  taker_.setCancelled(true);
  thread_.stop();
  taker_.setCancelled(false);
  progress_.cutOff();
  setStopping(false);
}

void
SequenceStream::dropJobs()
{
  const std::lock_guard lock(mutex_);
  jobs_ = {};
  is_job_over_ = true;
}

std::optional<SequenceStream::Job>
SequenceStream::nextJob()
{
  const std::lock_guard lock(mutex_);
  if (jobs_.queue.empty() && !jobs_.are_endless)
    return std::nullopt;
  if (std::exchange(is_new_, false))
    progress_.beginStream();
  is_job_over_ = false;
  if (jobs_.queue.empty())
    return Job::Observation;
  const Job job = jobs_.queue.front();
  jobs_.queue.pop_front();
  return job;
}

bool
SequenceStream::isJobOver() const
{
  const std::lock_guard lock(mutex_);
  return is_job_over_;
}

/** One step of the thread. */
bool
SequenceStream::doJobs()
{
  try {
    while (const auto job = nextJob())
      while (!finishesObservation() && *job == Job::Observation && !isJobOver()) {
      }
  }
  catch (...) {
    dropJobs();
    progress_.cutOff();
    throw;
  }
  return true;
}

/** Takes a shot and passes it to the callbacks. \return true if it completes the
 * observation */
bool
SequenceStream::finishesObservation()
{
  const Shot shot = progress_.next();
  const Settings current = settings();
  const TrinocularFrame::ConstPtr seen = take(shot, current);
  if (!seen)
    return false;
  const auto frame = pcl::make_shared<TrinocularFrame>(*seen);
  frame->number = shot.number;
  frame->observation = shot.observation;
  frame->pattern = shot.pattern;
  progress_.give(shot);
  signal_(frame);
  if (needsMore(shot, *frame, current.want_more))
    return false;
  progress_.finish(shot);
  return true;
}

TrinocularFrame::ConstPtr
SequenceStream::take(const Shot& shot, const Settings& current)
{
  const RgbImage* pattern = nullptr;
  if (shot.pattern != TrinocularFrame::no_pattern)
    pattern = &patterns_[static_cast<std::size_t>(shot.pattern)];
  taker_.show(pattern);
  if (!taker_.settle(current.settle_time))
    return nullptr;
  return taker_.shoot(current.shot_timeout);
}

bool
SequenceStream::needsMore(const Shot& shot,
                          const TrinocularFrame& frame,
                          const WantMore& want_more) const
{
  if (progress_.isLast(shot))
    return false;
  if (shot.pattern == TrinocularFrame::no_pattern || !want_more || isJobOver() ||
      !progress_.isUnderWay(shot))
    return true;
  return want_more(frame);
}

void
SequenceStream::end()
{
  const bool is_asked_again = [this] {
    const std::lock_guard lock(mutex_);
    is_new_ = true;
    return jobs_.are_endless || !jobs_.queue.empty();
  }();
  // The request was made after an error had ended the jobs, but before the thread could
  // accept it.
  if (is_asked_again)
    thread_.add(1);
  taker_.finish();
}

} // namespace pcl::acmap
