#include "frame_queue.h"

#include <algorithm>

namespace pcl::acmap {

FrameQueue::FrameQueue(std::size_t most)
: most_(most)
{}

void
FrameQueue::push(const TrinocularFrame::ConstPtr& frame)
{
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return is_closed_ || frames_.size() < most_; });
  if (is_closed_)
    return;
  frames_.push_back(frame);
  changed_.notify_all();
}

TrinocularFrame::ConstPtr
FrameQueue::pop(std::chrono::milliseconds timeout)
{
  std::unique_lock lock(mutex_);
  if (!changed_.wait_for(lock, timeout, [&] { return !frames_.empty(); }))
    return nullptr;
  TrinocularFrame::ConstPtr frame = frames_.front();
  frames_.pop_front();
  changed_.notify_all();
  return frame;
}

void
FrameQueue::close()
{
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  changed_.notify_all();
}

std::size_t
queueLength(std::size_t frame_bytes)
{
  constexpr std::size_t bytes = std::size_t{128} << 20;
  constexpr std::size_t least = 4;
  return std::max(least, bytes / std::max<std::size_t>(frame_bytes, 1));
}

} // namespace pcl::acmap
