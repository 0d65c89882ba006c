#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace pcl {

/** \brief Writes frames as they come into a raw session: a folder with `rig.yaml`, a file
 * for each frame, and `session.yaml` once it is finished.
 *
 * Each frame stands whole in its place, and on the disk, before \ref record returns: what
 * is killed, or loses its power, loses at most the frame it was at, and \ref
 * TrinocularFileGrabber reads the others. A camera that does not wait loses frames when
 * the disk is slow now and then: \ref setMostWaiting. Nothing is overwritten. Not for
 * several threads at once.
 * \code
 * pcl::TrinocularRecorder recorder ("session", grabber.getRig ());
 * const std::function<pcl::TrinocularGrabber::FrameCallback> record =
 *     [&] (const pcl::TrinocularFrame::ConstPtr& frame) { recorder.record (*frame); };
 * grabber.registerCallback (record);
 * grabber.start ();
 * grabber.wait ();
 * recorder.finish ();
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT TrinocularRecorder {
public:
  /** \brief Begins a session of rectified frames.
   * \param[in] folder is made where it is missing; what it lies in must be there
   * \param[in] rig a baseline of 0 says that there is no such camera
   * \throws BadArgumentException when no camera can be like this
   * \throws OutputFileException when a session, or a part of one, lies there already, or
   * nothing can be written */
  TrinocularRecorder(const std::string& folder, const TrinocularRig& rig);

  /** \brief Begins a session of frames as the cameras see them, before rectification:
   * its `rig.yaml` has the cameras too, for \ref loadRigCalibration.
   * \param[in] rig what rectification will make of them, of the same size
   * \param[in] calibration the cameras; the frames are of its size
   * \throws BadArgumentException also for cameras that cannot be, or are not those of the
   * rig
   * \throws OutputFileException as above */
  TrinocularRecorder(const std::string& folder,
                     const TrinocularRig& rig,
                     const RigCalibration& calibration);

  /** \brief Writes the frames that wait. Does not finish the session. */
  ~TrinocularRecorder();

  TrinocularRecorder(const TrinocularRecorder&) = delete;
  TrinocularRecorder&
  operator=(const TrinocularRecorder&) = delete;

  /** \brief How many frames may wait to be written, by a thread of its own (default 0:
   * \ref record writes). Then record takes over a frame and returns; only when so many
   * wait does it wait, too. What is killed loses those that wait.
   * \throws BadArgumentException beyond 1000 */
  void
  setMostWaiting(std::size_t frames);

  std::size_t
  getMostWaiting() const;

  /** \brief Writes a frame. One that is refused or fails leaves the session as it was.
   * \throws BadArgumentException naming the frame's number: no frame can be like this
   * (see \ref saveTrinocularFrame), its images are not those of the rig, its number or its
   * pair of observation and pattern was there before; also after \ref finish
   * \throws OutputFileException when it could not be written whole, or one that had
   * waited: then this one was not taken */
  void
  record(const TrinocularFrame& frame);

  /** \brief Writes the frames that wait, and `session.yaml`: the session is complete.
   * Again: does nothing.
   * \throws OutputFileException when it, or a frame that had waited, could not be written
   * whole; the session is not finished then */
  void
  finish();

  /** \brief How many frames were written. */
  std::size_t
  frames() const;

  /** \brief How long the files of these frames are together. */
  std::uintmax_t
  bytes() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
