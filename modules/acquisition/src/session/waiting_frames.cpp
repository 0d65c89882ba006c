#include "waiting_frames.h"

#include <utility>

namespace pcl::acmap {

WaitingFrames::WaitingFrames(std::function<void(const TrinocularFrame&)> write)
: write_(std::move(write))
{}

WaitingFrames::~WaitingFrames()
{
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable())
    thread_.join();
}

void
WaitingFrames::add(TrinocularFrame frame, std::size_t maximum)
{
  std::unique_lock lock(mutex_);
  if (!thread_.joinable())
    thread_ = std::thread([this] { run(); });
  // The frame that is being written is still in the queue, but does not wait.
  changed_.wait(lock, [&] { return frames_.size() <= maximum; });
  frames_.push_back(std::move(frame));
  changed_.notify_all();
}

void
WaitingFrames::waitForAll()
{
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return frames_.empty(); });
}

void
WaitingFrames::throwFault()
{
  std::exception_ptr fault;
  {
    const std::lock_guard lock(mutex_);
    std::swap(fault, fault_);
  }
  if (fault)
    std::rethrow_exception(fault);
}

void
WaitingFrames::run()
{
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return ends_ || !frames_.empty(); });
    if (frames_.empty())
      return;
    const TrinocularFrame& frame = frames_.front(); // its address does not change
    lock.unlock();
    std::exception_ptr fault;
    try {
      write_(frame);
    }
    catch (...) {
      fault = std::current_exception();
    }
    lock.lock();
    if (!fault_)
      fault_ = fault;
    frames_.pop_front();
    changed_.notify_all();
  }
}

} // namespace pcl::acmap
