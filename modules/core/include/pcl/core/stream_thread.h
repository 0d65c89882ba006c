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

/** \brief What a \ref TrinocularGrabber streams with: gives frames in a thread of its
 * own, as many as were asked for, at a rate. All members may be called from any thread,
 * and from within a step or the end. */
class ACMAP_EXPORT StreamThread {
public:
  using Seconds = std::chrono::duration<double>;

  static constexpr std::size_t endless = std::numeric_limits<std::size_t>::max();

  /** \param[in] step gives the next frame, false at the end; what it throws ends the
   * stream and is kept
   * \param[in] period between two frames; one that is late is not made up for
   * \param[in] end called in the thread, once for each stream, whatever ended it, while
   * \ref isRunning still says true and \ref error says why; what it throws is kept
   * where nothing was before. Frames asked for meanwhile are a stream of their own,
   * after it. */
  StreamThread(std::function<bool()> step,
               Seconds period,
               std::function<void()> end = {});

  ~StreamThread();

  /** \brief Asks for more frames; starts the thread where none runs. */
  void
  add(std::size_t frames);

  /** \brief No step runs, and none begins, after this has returned; nor does the end.
   * From within a step: this step is the last one. */
  void
  stop();

  /** \brief Waits until nothing runs; from within a step or the end it returns at once.
   */
  void
  wait();

  bool
  isRunning() const;

  /** \brief Whether \ref endless frames are still to be given. */
  bool
  isEndless() const;

  /** \brief What ended the last stream, null when it ended well or runs. */
  std::exception_ptr
  error() const;

  /** \brief Whether the caller is a step or the end. */
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

  std::mutex lifecycle_; // held while the thread is started or joined; never by itself
  std::thread thread_;

  mutable std::mutex mutex_; // of all below
  std::condition_variable changed_;
  std::size_t wanted_ = 0; // frames still to be given
  bool is_running_ = false;
  bool is_closing_ = false; // somebody outside waits in stop
  std::exception_ptr error_;
};

} // namespace pcl::acmap
