#pragma once

#include <pcl/core/export.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <mutex>
#include <thread>

namespace pcl::acmap {

/** \brief Implementation of the stream of a \ref TrinocularGrabber, calls a step
 * function in its own thread, for the requested number of frames, at a given rate. All
 * members may be called from any thread, also from the step and end functions. */
class ACMAP_EXPORT StreamThread {
public:
  using Seconds = std::chrono::duration<double>;

  static constexpr std::size_t endless = std::numeric_limits<std::size_t>::max();

  /** \param[in] step delivers the next frame, returns false at the end; an exception
   * that it throws ends the stream and is kept
   * \param[in] period between two frames; delays are not compensated by later frames
   * \param[in] end called in the thread once for each stream, regardless of the reason
   * why it ended, while \ref isRunning still returns true and \ref error returns the
   * reason; an exception that it throws is kept if there was none before. Frames that
   * are requested during this call belong to a new stream after it. */
  StreamThread(std::function<bool()> step,
               Seconds period,
               std::function<void()> end = {});

  ~StreamThread();

  /** \brief Requests more frames; starts the thread if it is not running. */
  void
  add(std::size_t frames);

  /** \brief Stops the stream. Neither the step nor the end function is running or
   * called after this function has returned. If it is called from a step, that step is
   * the last one. */
  void
  stop();

  /** \brief Waits until the stream has ended; returns at once if it is called from the
   * step or end function. */
  void
  wait();

  bool
  isRunning() const;

  /** \brief Returns true if the number of remaining frames is \ref endless. */
  bool
  isEndless() const;

  /** \brief The exception that ended the last stream; null if it ended normally or is
   * still running. */
  std::exception_ptr
  error() const;

  /** \brief Returns true if it is called from the step or end function. */
  bool
  isWithin() const;

private:
  void
  wish(std::size_t frames);

  void
  begin(std::size_t frames);

  void
  run();

  void
  giveFrames(std::unique_lock<std::mutex>& lock);

  void
  finish(std::unique_lock<std::mutex>& lock);

  const std::function<bool()> step_;
  const std::function<void()> end_;
  const std::chrono::steady_clock::duration period_;

  // locked while the thread is started or joined, but not by the thread itself
  std::mutex lifecycle_;
  std::thread thread_;

  mutable std::mutex mutex_; // protects all members below
  std::condition_variable changed_;
  std::size_t wanted_ = 0; // number of remaining frames
  bool is_running_ = false;
  bool is_closing_ = false; // another thread is waiting in stop
  std::exception_ptr error_;
};

} // namespace pcl::acmap
