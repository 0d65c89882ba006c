#pragma once

#include <pcl/core/trinocular_frame.h>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace pcl::acmap {

/** \brief Frames that wait to be written, and a thread that does it, in their order. */
class WaitingFrames {
public:
  /** \param[in] write what it throws is kept; the frames behind are written all the same
   */
  explicit WaitingFrames(std::function<void(const TrinocularFrame&)> write);

  /** \brief Writes what waits. */
  ~WaitingFrames();

  WaitingFrames(const WaitingFrames&) = delete;
  WaitingFrames&
  operator=(const WaitingFrames&) = delete;

  /** \brief Returns once fewer than \a most wait before it, with one more. */
  void
  add(TrinocularFrame frame, std::size_t most);

  /** \brief Returns when nothing waits and nothing is being written. */
  void
  waitForAll();

  /** \brief Throws what the first write threw that failed since the last call. */
  void
  throwFault();

private:
  void
  run();

  const std::function<void(const TrinocularFrame&)> write_;
  std::mutex mutex_; // of all that follows, but the thread
  std::condition_variable changed_;
  std::deque<TrinocularFrame> frames_; // the first one is being written
  std::exception_ptr fault_;
  bool ends_ = false;
  std::thread thread_; // once there was a frame
};

} // namespace pcl::acmap
