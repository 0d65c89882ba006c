#pragma once

#include <pcl/core/trinocular_frame.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>

namespace pcl::acmap {

/** \brief Frames on their way from a grabber's thread to the one that works with them. */
class FrameQueue {
public:
  /** \param[in] most frames that may wait, at least 1 */
  explicit FrameQueue(std::size_t most);

  /** \brief Adds a frame; waits while there are too many. Once the queue is closed, the
   * frame is dropped. */
  void
  push(const TrinocularFrame::ConstPtr& frame);

  /** \brief Takes the first frame.
   * \return null when none came in time */
  TrinocularFrame::ConstPtr
  pop(std::chrono::milliseconds timeout);

  /** \brief No frame is added any more, and nobody waits; those that are there stay. */
  void
  close();

private:
  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<TrinocularFrame::ConstPtr> frames_;
  bool is_closed_ = false;
};

/** \brief How many frames may wait: some seconds of a stream, while the disk is busy. */
std::size_t
queueLength(std::size_t frame_bytes);

} // namespace pcl::acmap
