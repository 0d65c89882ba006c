#include <pcl/core/stream_thread.h>

#include <algorithm>
#include <utility>

namespace pcl::acmap {

namespace {

thread_local const StreamThread* stream_of_thread = nullptr;

} // namespace

StreamThread::StreamThread(std::function<bool()> step,
                           Seconds period,
                           std::function<void()> end)
: step_(std::move(step))
, end_(std::move(end))
, period_(std::chrono::duration_cast<std::chrono::steady_clock::duration>(period))
{}

StreamThread::~StreamThread()
{
  stop();
}

bool
StreamThread::isWithin() const
{
  return stream_of_thread == this;
}

/** Requires that mutex_ is locked. */
void
StreamThread::wish(std::size_t frames)
{
  wanted_ = frames > endless - wanted_ ? endless : wanted_ + frames;
  changed_.notify_all();
}

void
StreamThread::add(std::size_t frames)
{
  if (isWithin()) {
    const std::lock_guard lock(mutex_);
    if (!is_closing_)
      wish(frames);
    return;
  }
  const std::lock_guard lifecycle(lifecycle_);
  std::unique_lock lock(mutex_);
  if (is_running_) {
    wish(frames);
    return;
  }
  lock.unlock();
  if (thread_.joinable())
    thread_.join();
  begin(frames);
}

/** Requires that lifecycle_ is locked and no thread is running. */
void
StreamThread::begin(std::size_t frames)
{
  std::unique_lock lock(mutex_);
  error_ = nullptr;
  wish(frames);
  is_running_ = true;
  lock.unlock();
  try {
    thread_ = std::thread(&StreamThread::run, this);
  }
  catch (...) {
    lock.lock();
    wanted_ = 0;
    is_running_ = false;
    throw;
  }
}

void
StreamThread::stop()
{
  if (isWithin()) {
    const std::lock_guard lock(mutex_);
    wanted_ = 0;
    return;
  }
  const std::lock_guard lifecycle(lifecycle_);
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    wanted_ = 0;
    changed_.notify_all();
  }
  if (thread_.joinable())
    thread_.join();
  const std::lock_guard lock(mutex_);
  is_closing_ = false;
}

void
StreamThread::wait()
{
  if (isWithin())
    return;
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !is_running_; });
}

bool
StreamThread::isRunning() const
{
  const std::lock_guard lock(mutex_);
  return is_running_;
}

bool
StreamThread::isEndless() const
{
  const std::lock_guard lock(mutex_);
  return wanted_ == endless;
}

std::exception_ptr
StreamThread::error() const
{
  const std::lock_guard lock(mutex_);
  return error_;
}

void
StreamThread::run()
{
  stream_of_thread = this;
  std::unique_lock lock(mutex_);
  do {
    error_ = nullptr;
    try {
      giveFrames(lock);
    }
    catch (...) {
      if (!lock.owns_lock())
        lock.lock();
      error_ = std::current_exception();
    }
    wanted_ = 0;
    finish(lock);
  } while (wanted_ > 0); // requested while the last stream was ending
  is_running_ = false;
  changed_.notify_all();
}

void
StreamThread::finish(std::unique_lock<std::mutex>& lock)
{
  if (!end_)
    return;
  lock.unlock();
  std::exception_ptr error;
  try {
    end_();
  }
  catch (...) {
    error = std::current_exception();
  }
  lock.lock();
  if (!error_)
    error_ = error;
}

void
StreamThread::giveFrames(std::unique_lock<std::mutex>& lock)
{
  auto due = std::chrono::steady_clock::now();
  for (;;) {
    changed_.wait_until(lock, due, [this] { return wanted_ == 0; });
    if (wanted_ == 0)
      return;
    if (wanted_ != endless)
      --wanted_;
    lock.unlock();
    const bool was_given = step_();
    due = std::max(due + period_, std::chrono::steady_clock::now());
    lock.lock();
    if (!was_given)
      return;
  }
}

} // namespace pcl::acmap
