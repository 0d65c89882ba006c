#pragma once

#include <pcl/core/trinocular_frame.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>

namespace pcl::acmap {

/** \brief Queue of frames between a grabber's thread and the thread that processes
 * them. */
class FrameQueue {
public:
  /** \param[in] maximum maximum number of waiting frames, at least 1 */
  explicit FrameQueue(std::size_t maximum)
  : maximum_(maximum)
  {}

  /** \brief Adds a frame; blocks while the queue is full. Once the queue is closed, the
   * frame is dropped. */
  void
  push(const TrinocularFrame::ConstPtr& frame)
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_closed_ || frames_.size() < maximum_; });
    if (!is_closed_)
      frames_.push_back(frame);
    changed_.notify_all();
  }

  /** \brief Removes the first frame.
   * \return null after a timeout */
  TrinocularFrame::ConstPtr
  pop(std::chrono::milliseconds timeout)
  {
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, timeout, [&] { return !frames_.empty(); }))
      return nullptr;
    TrinocularFrame::ConstPtr frame = frames_.front();
    frames_.pop_front();
    changed_.notify_all();
    return frame;
  }

  /** \brief Closes the queue: no frame is added any more, and waiting threads return.
   * Frames in the queue are kept. */
  void
  close()
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

private:
  const std::size_t maximum_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<TrinocularFrame::ConstPtr> frames_;
  bool is_closed_ = false;
};

/** \brief Maximum number of waiting frames: some seconds of a stream, while the disk is
 * busy. */
inline std::size_t
queueLength(std::size_t frame_bytes)
{
  constexpr std::size_t bytes = std::size_t{128} << 20;
  return std::max<std::size_t>(4, bytes / std::max<std::size_t>(frame_bytes, 1));
}

} // namespace pcl::acmap
