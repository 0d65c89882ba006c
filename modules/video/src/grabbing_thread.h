#pragma once

#include <pcl/video/video_source.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

namespace pcl::acmap {

/** \brief Grabs the images of one camera in a thread of its own: cameras are grabbed at
 * the same time, and a driver that blocks without end blocks nothing else. */
class GrabbingThread {
public:
  using Clock = std::chrono::steady_clock;

  enum class Outcome {
    Image,
    End,    ///< \ref VideoSource::grab returned false
    Waiting ///< not yet known
  };

  explicit GrabbingThread(std::unique_ptr<VideoSource> source);

  /** \brief Ends the thread. If its driver blocks, it is left to itself, and releases
   * the camera when the driver returns. */
  ~GrabbingThread();

  GrabbingThread(const GrabbingThread&) = delete;
  GrabbingThread&
  operator=(const GrabbingThread&) = delete;

  /** \brief Begins to grab the next image; goes on if one is being grabbed that was not
   * waited for. */
  void
  begin();

  /** \brief Waits until the image is there.
   * \throws what the source has thrown */
  Outcome
  wait(Clock::time_point until);

  /** \brief The camera; not to be used between \ref begin and the end of \ref wait. */
  VideoSource&
  source()
  {
    return *shared_->source;
  }

private:
  enum class Task { None, Grab, End };

  struct Shared {
    std::unique_ptr<VideoSource> source; // used by the thread during a task only
    std::mutex mutex;
    std::condition_variable changed;
    Task task = Task::None;
    bool has_image = false;
    std::exception_ptr error;
  };

  static void
  run(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_;
  std::thread thread_;
};

} // namespace pcl::acmap
