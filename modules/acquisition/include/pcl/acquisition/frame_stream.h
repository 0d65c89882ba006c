#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_grabber.h>

#include <boost/signals2/connection.hpp>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace pcl {

namespace acmap {
class FrameQueue;
} // namespace acmap

/** \brief The frames of a grabber in the thread that wants them, instead of in callbacks.
 *
 * Frames wait in a queue of up to 128 MB (at least four): some seconds of a camera, while the
 * disk is busy. A grabber whose frames find no room waits.
 * \code
 * pcl::FrameStream stream (grabber);
 * grabber.start ();
 * stream.pass ([&] (const pcl::TrinocularFrame::ConstPtr& frame) {
 *   recorder.record (*frame);
 *   return recorder.frames () < 100;
 * });
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT FrameStream {
public:
  /** \brief Takes a frame. \return false to end the stream */
  using UseFrame = std::function<bool(const TrinocularFrame::ConstPtr& frame)>;

  /** \brief Called after each frame, and every 50 ms while none comes; may throw.
   * \return true to end the stream: frames that wait are still passed */
  using IsOver = std::function<bool()>;

  /** \brief Listens to a grabber, which it does not start.
   * \param[in] grabber outlives this object */
  explicit FrameStream(TrinocularGrabber& grabber);

  /** \brief Ends the stream. Afterwards no callback of the grabber is called. */
  ~FrameStream();

  FrameStream(const FrameStream&) = delete;
  FrameStream&
  operator=(const FrameStream&) = delete;

  /** \brief The next frame; null if none comes in time.
   * \param[in] timeout time to wait for it */
  TrinocularFrame::ConstPtr
  next(std::chrono::milliseconds timeout);

  /** \brief Passes frames on until the stream has ended and none waits, or one is refused.
   * \param[in] is_over empty: only the grabber and the use end the stream
   * \throws what the callbacks throw, and the error of the grabber */
  void
  pass(const UseFrame& use, const IsOver& is_over = {});

  /** \brief Stops the grabber. Frames that wait are kept, no other one comes. */
  void
  end();

  /** \brief Number of frames that were taken. */
  std::size_t
  frames() const
  {
    return frames_;
  }

private:
  TrinocularGrabber& grabber_;
  std::unique_ptr<acmap::FrameQueue> queue_;
  boost::signals2::connection connection_;
  std::size_t frames_ = 0;
};

} // namespace pcl
