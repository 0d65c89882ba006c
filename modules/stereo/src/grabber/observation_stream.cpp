#include "grabber/observation_stream.h"

#include <utility>

namespace pcl::acmap {

ObservationStream::ObservationStream(shared_ptr<TrinocularGrabber> frames,
                                     ObservationMaker::Give give)
: frames_(std::move(frames))
, maker_(frames_->getRig(), std::move(give))
, entrance_(std::make_shared<Entrance>())
, thread_([this] { return run(); }, {})
{
  entrance_->stream = this;
  const std::function<TrinocularGrabber::FrameCallback> take =
      [entrance = entrance_](const TrinocularFrame::ConstPtr& frame) {
        const std::lock_guard lock(entrance->mutex);
        if (entrance->stream)
          entrance->stream->takeIfStreaming(frame);
      };
  connection_ = frames_->registerCallback(take);
}

ObservationStream::~ObservationStream()
{
  stop();
  connection_.disconnect();
  // Other code may be running the frame grabber.
  const std::lock_guard lock(entrance_->mutex);
  entrance_->stream = nullptr;
}

/** Returns true if the caller is a callback, in one of the two threads. */
bool
ObservationStream::isWithin() const
{
  const std::lock_guard lock(mutex_);
  const std::thread::id self = std::this_thread::get_id();
  return self == own_thread_ || self == frame_thread_;
}

void
ObservationStream::start()
{
  if (isWithin()) {
    const std::lock_guard lock(mutex_);
    if (wish_ == Wish::Pause)
      wish_ = Wish::Restart;
    return;
  }
  const std::lock_guard lifecycle(lifecycle_);
  thread_.add(StreamThread::endless);
}

void
ObservationStream::stop()
{
  if (isWithin()) {
    {
      const std::lock_guard lock(mutex_);
      if (wish_ != Wish::Stop)
        wish_ = Wish::Pause;
    }
    frames_->stop();
    return;
  }
  const std::lock_guard lifecycle(lifecycle_);
  if (!thread_.isRunning())
    return;
  {
    const std::lock_guard lock(mutex_);
    wish_ = Wish::Stop;
  }
  frames_->stop();
  if (frames_->isRunning())
    return; // called from another callback of the frame grabber, for its last frame
  thread_.stop();
  const std::lock_guard lock(mutex_);
  wish_ = Wish::Stream;
}

void
ObservationStream::wait()
{
  if (!isWithin())
    thread_.wait();
}

void
ObservationStream::takeIfStreaming(const TrinocularFrame::ConstPtr& frame)
{
  {
    const std::lock_guard lock(mutex_);
    if (!takes_frames_)
      return;
    frame_thread_ = std::this_thread::get_id();
  }
  maker_.take(frame);
}

bool
ObservationStream::run()
{
  std::exception_ptr error;
  try {
    if (streamFrames())
      finish();
  }
  catch (...) {
    error = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  own_thread_ = {};
  is_restarted_ = !error && wish_ == Wish::Restart;
  wish_ = Wish::Stream;
  if (error)
    std::rethrow_exception(error);
  return is_restarted_;
}

/** \return false if the stream was stopped before it started */
bool
ObservationStream::streamFrames()
{
  {
    // With the lock, a request takes effect either before the start or after it.
    const std::lock_guard lock(mutex_);
    if (wish_ == Wish::Stop)
      return false;
    own_thread_ = std::this_thread::get_id();
    if (!is_restarted_)
      maker_.clearReport();
    maker_.resume();
    frames_->start();
    takes_frames_ = true;
  }
  frames_->wait();
  const std::lock_guard lock(mutex_);
  takes_frames_ = false;
  frame_thread_ = {};
  return true;
}

void
ObservationStream::finish()
{
  const Wish wish = [this] {
    const std::lock_guard lock(mutex_);
    return wish_;
  }();
  if (const std::exception_ptr error = frames_->getError()) {
    maker_.cutOff("an error");
    std::rethrow_exception(error);
  }
  const bool gave_one = frames_->getFramesPerSecond() == 0.0F && !maker_.isAfterBreak();
  if (wish == Wish::Stop)
    maker_.cutOff("stop");
  else if (wish == Wish::Stream && !gave_one)
    maker_.finish();
}

} // namespace pcl::acmap
