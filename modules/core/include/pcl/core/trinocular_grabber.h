#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/io/grabber.h>

#include <exception>
#include <functional>

namespace pcl {

/** \brief What gives frames of a trinocular rig, whatever it is: a camera, a recording,
 * a simulation. Section II-A of "Active Stereo Based Compact Mapping".
 *
 * Callbacks run in a thread of the grabber, one after another, in the order of the
 * shots. An error, also one that a callback throws, ends the stream and is kept for \ref
 * getError; no exception leaves the thread. \ref start, \ref stop, \ref trigger and \ref
 * rewind may be called at any time, any number of times, from any thread and from a
 * callback. \ingroup core */
class ACMAP_EXPORT TrinocularGrabber : public Grabber {
public:
  ~TrinocularGrabber() noexcept override;

  /** \brief Signature of the one signal, for PCL's registerCallback. */
  using FrameCallback = void(const TrinocularFrame::ConstPtr& frame);

  /** \brief Streams on from where it stands; does nothing while it streams. */
  void
  start() override = 0;

  /** \brief Ends the stream, where it stands; no callback is called after it has returned.
   * From a callback: this callback is the last one. */
  void
  stop() override = 0;

  /** \brief Gives one more shot; none while a stream runs, or at the end. Returns at once.
   */
  virtual void
  trigger() = 0;

  /** \brief The first shot is the next one, where shots can come again. */
  virtual void
  rewind() = 0;

  /** \brief Geometry of the frames. */
  virtual TrinocularRig
  getRig() const = 0;

  /** \brief Waits until the stream has ended by itself or was stopped; in a callback it
   * returns at once. */
  virtual void
  wait() = 0;

  /** \brief What ended the stream, null when it ended well or still runs; the next
   * stream forgets it. */
  virtual std::exception_ptr
  getError() const = 0;
};

} // namespace pcl
