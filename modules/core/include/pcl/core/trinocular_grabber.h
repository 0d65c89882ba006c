#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/io/grabber.h>

#include <exception>
#include <functional>

namespace pcl {

/** \brief Interface of sources of frames of a trinocular rig: a camera, a recording or
 * a simulation. Section II-A of "Active Stereo Based Compact Mapping".
 *
 * Callbacks run in a thread of the grabber, one after another, in the order of the
 * shots. An error, including an exception of a callback, ends the stream and is kept
 * for \ref getError; no exception leaves the thread. \ref start, \ref stop,
 * \ref trigger and \ref rewind may be called at any time, any number of times, from any
 * thread and from a callback. \ingroup core */
class ACMAP_EXPORT TrinocularGrabber : public Grabber {
public:
  ~TrinocularGrabber() noexcept override;

  /** \brief Signature of the only signal, for PCL's registerCallback. */
  using FrameCallback = void(const TrinocularFrame::ConstPtr& frame);

  /** \brief Continues the stream from its current position; does nothing if it is
   * running. */
  void
  start() override = 0;

  /** \brief Stops the stream at its current position; no callback is called after it
   * has returned. If it is called from a callback, this callback is the last one. */
  void
  stop() override = 0;

  /** \brief Delivers one more shot; none if a stream is running, or at the end. Returns
   * at once. */
  virtual void
  trigger() = 0;

  /** \brief Continues with the first shot, if the source can repeat shots. */
  virtual void
  rewind() = 0;

  /** \brief Geometry of the frames. */
  virtual TrinocularRig
  getRig() const = 0;

  /** \brief Waits until the stream has ended by itself or was stopped; if it is called
   * from a callback, it returns at once. */
  virtual void
  wait() = 0;

  /** \brief The exception that ended the stream; null if it ended normally or is still
   * running. It is reset by the next stream. */
  virtual std::exception_ptr
  getError() const = 0;
};

} // namespace pcl
