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

/** \brief A queue of frames and a thread that writes them in order. */
class WaitingFrames {
public:
  /** \param[in] write its exceptions are stored; the following frames are written
   * nevertheless */
  explicit WaitingFrames(std::function<void(const TrinocularFrame&)> write);

  /** \brief Writes the waiting frames. */
  ~WaitingFrames();

  WaitingFrames(const WaitingFrames&) = delete;
  WaitingFrames&
  operator=(const WaitingFrames&) = delete;

  /** \brief Waits until fewer than \a maximum frames are waiting, then adds a frame. */
  void
  add(TrinocularFrame frame, std::size_t maximum);

  /** \brief Waits until all frames are written. */
  void
  waitForAll();

  /** \brief Throws the first exception of a write since the last call. */
  void
  throwFault();

private:
  void
  run();

  const std::function<void(const TrinocularFrame&)> write_;
  std::mutex mutex_; // protects the members below, except for the thread
  std::condition_variable changed_;
  std::deque<TrinocularFrame> frames_; // the first one is being written
  std::exception_ptr fault_;
  bool ends_ = false;
  std::thread thread_; // started with the first frame
};

} // namespace pcl::acmap
