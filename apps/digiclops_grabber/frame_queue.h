#pragma once

#include <pcl/core/trinocular_frame.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>

namespace pcl::acmap {

/** \brief Queue of frames between a grabber's thread and the thread that processes
 * them. */
class FrameQueue {
public:
  /** \param[in] most maximum number of waiting frames, at least 1 */
  explicit FrameQueue(std::size_t most);

  /** \brief Adds a frame; blocks while the queue is full. Once the queue is closed, the
   * frame is dropped. */
  void
  push(const TrinocularFrame::ConstPtr& frame);

  /** \brief Removes the first frame.
   * \return null after a timeout */
  TrinocularFrame::ConstPtr
  pop(std::chrono::milliseconds timeout);

  /** \brief Closes the queue: no frame is added any more, and waiting threads return.
   * Frames in the queue are kept. */
  void
  close();

private:
  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<TrinocularFrame::ConstPtr> frames_;
  bool is_closed_ = false;
};

/** \brief Maximum number of waiting frames: some seconds of a stream, while the disk is
 * busy. */
std::size_t
queueLength(std::size_t frame_bytes);

} // namespace pcl::acmap
