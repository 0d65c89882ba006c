#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace pcl {

/** \brief Writes frames, as they arrive, to a raw session: a folder with `rig.yaml`,
 * one file per frame, and `session.yaml` once it is finished.
 *
 * Each frame is completely on the disk before \ref record returns: if the process is
 * killed or the power fails, at most the current frame is lost, and
 * \ref TrinocularFileGrabber reads the others. If the disk is slow at times, a live
 * camera loses frames; \ref setMostWaiting avoids this. Existing files are never
 * overwritten. The class must not be used by several threads at once.
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
   * \param[in] folder is created if it does not exist; its parent folder must exist
   * \param[in] rig a baseline of 0 means that this camera does not exist
   * \throws BadArgumentException if the rig is invalid
   * \throws OutputFileException when the folder already contains a session or a part of
   * one, or nothing can be written */
  TrinocularRecorder(const std::string& folder, const TrinocularRig& rig);

  /** \brief Begins a session of unrectified frames: its `rig.yaml` also contains the
   * calibration, for \ref loadRigCalibration.
   * \param[in] rig geometry after rectification, of the same size
   * \param[in] calibration the cameras; the frames have its size
   * \throws BadArgumentException also if the calibration is invalid or does not match
   * the rig
   * \throws OutputFileException as above */
  TrinocularRecorder(const std::string& folder,
                     const TrinocularRig& rig,
                     const RigCalibration& calibration);

  /** \brief Begins a session of either.
   * \param[in] cameras nothing for rectified frames
   * \throws as above */
  TrinocularRecorder(const std::string& folder,
                     const TrinocularRig& rig,
                     const std::optional<RigCalibration>& cameras);

  /** \brief Writes the waiting frames. Does not finish the session. */
  ~TrinocularRecorder();

  TrinocularRecorder(const TrinocularRecorder&) = delete;
  TrinocularRecorder&
  operator=(const TrinocularRecorder&) = delete;

  /** \brief Sets how many frames may wait to be written by a separate thread (default
   * 0: \ref record writes). With this thread, record copies a frame and returns; it
   * blocks only while this number of frames is waiting. If the process is killed, the
   * waiting frames are lost.
   * \throws BadArgumentException beyond 1000 */
  void
  setMostWaiting(std::size_t frames);

  std::size_t
  getMostWaiting() const;

  /** \brief Writes a frame. If a frame is rejected or cannot be written, the session
   * remains unchanged.
   * \throws BadArgumentException naming the frame's number, if the frame is invalid
   * (see \ref saveTrinocularFrame), its images do not match the rig, or its number or
   * its pair of observation and pattern was already recorded; also after \ref finish
   * \throws OutputFileException when it, or an earlier waiting frame, could not be
   * written completely; in the latter case this frame is not recorded */
  void
  record(const TrinocularFrame& frame);

  /** \brief Writes the waiting frames and `session.yaml`, which completes the session.
   * Does nothing when called again.
   * \throws OutputFileException when `session.yaml` or a waiting frame could not be
   * written completely; the session is then not finished */
  void
  finish();

  /** \brief Ends a session without frames by removing its files, and the folder if it was
   * created: nothing would read it, and it would be in the way of the next session. */
  void
  discardIfEmpty();

  /** \brief Number of frames that were written. */
  std::size_t
  frames() const;

  /** \brief Total size of the files of these frames. */
  std::uintmax_t
  bytes() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
