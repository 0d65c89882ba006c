#include "grabbing_thread.h"

#include <utility>

namespace pcl::acmap {

GrabbingThread::GrabbingThread(std::unique_ptr<VideoSource> source)
: shared_(std::make_shared<Shared>())
{
  shared_->source = std::move(source);
  thread_ = std::thread([shared = shared_] { run(shared); });
}

GrabbingThread::~GrabbingThread()
{
  constexpr std::chrono::seconds patience(1);
  bool is_blocked = false;
  {
    std::unique_lock lock(shared_->mutex);
    is_blocked = !shared_->changed.wait_for(
        lock, patience, [this] { return shared_->task == Task::None; });
    shared_->task = Task::End;
    shared_->changed.notify_all();
  }
  if (is_blocked)
    thread_.detach();
  else
    thread_.join();
}

void
GrabbingThread::begin()
{
  const std::lock_guard lock(shared_->mutex);
  shared_->task = Task::Grab;
  shared_->changed.notify_all();
}

GrabbingThread::Outcome
GrabbingThread::wait(Clock::time_point until)
{
  std::unique_lock lock(shared_->mutex);
  if (!shared_->changed.wait_until(
          lock, until, [this] { return shared_->task == Task::None; }))
    return Outcome::Waiting;
  if (shared_->error)
    std::rethrow_exception(std::exchange(shared_->error, nullptr));
  return shared_->has_image ? Outcome::Image : Outcome::End;
}

void
GrabbingThread::run(const std::shared_ptr<Shared>& shared)
{
  std::unique_lock lock(shared->mutex);
  for (;;) {
    shared->changed.wait(lock, [&] { return shared->task != Task::None; });
    if (shared->task == Task::End)
      return;
    lock.unlock();
    bool has_image = false;
    std::exception_ptr error;
    try {
      has_image = shared->source->grab();
    }
    catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (shared->task == Task::End)
      return;
    shared->has_image = has_image;
    shared->error = error;
    shared->task = Task::None;
    shared->changed.notify_all();
  }
}

} // namespace pcl::acmap
