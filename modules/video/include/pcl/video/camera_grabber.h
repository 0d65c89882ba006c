#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/streamed_grabber.h>
#include <pcl/video/video_source.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief State of one camera of a \ref CameraGrabber. \ingroup video */
struct CameraState {
  std::string device;             ///< as given by the user
  bool is_recording = false;      ///< a file
  double frames_per_second = 0;   ///< of the camera; 0 if it does not tell
  std::optional<double> exposure; ///< s, as the camera tells it
  std::optional<double> gain;     ///< in units of the driver

  /** \brief Is its exposure fixed? Known after the first frame. */
  bool is_exposure_fixed = false;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const CameraState& camera, Visitor&& visit)
{
  visit({"device"}, camera.device);
  visit({"is_recording"}, camera.is_recording);
  visit({"rate", "1/s"}, camera.frames_per_second);
  visit({"is_exposure_fixed"}, camera.is_exposure_fixed);
  visit({"exposure", "s"}, camera.exposure);
  visit({"gain"}, camera.gain);
}

/** \brief Statistics of a \ref CameraGrabber over all its streams. A remark tells which
 * settings a camera refused, and which shots had to be repeated.
 * \ingroup video */
struct CameraGrabberReport : Report {
  std::size_t frames = 0;    ///< number of frames that were passed to the callbacks
  std::size_t discarded = 0; ///< number of images of each camera that were thrown away
  std::size_t broken = 0;    ///< incomplete images
  std::size_t moved = 0;     ///< how often two successive images differed too much

  /** \brief Largest change between the two images of a frame that was passed on, grey
   * levels; see \ref CameraGrabber::setMaximumChange. */
  double largest_change = 0;

  /** \brief Frames per second that were passed on during the last two seconds; 0 if not
   * yet known. */
  double frames_per_second = 0;

  /** \brief In the order of the devices. */
  std::vector<CameraState> cameras;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const CameraGrabberReport& report, Visitor&& visit)
{
  visit({"frames"}, report.frames);
  visit({"cameras"}, report.cameras);
  visit({"discarded_images"}, report.discarded);
  visit({"broken"}, report.broken);
  visit({"moved"}, report.moved);
  visit({"largest_change"}, report.largest_change);
  visit({"frames_per_second", "1/s"}, report.frames_per_second);
}

/** \brief Grabs frames of two or three separate cameras, for example webcams on a bar.
 * Section II-A of "Active Stereo Based Compact Mapping".
 *
 * The cameras are not synchronised: their images show different moments, therefore rig
 * and scene must stand still during a shot. This is checked: a frame is passed on only
 * if two successive images of each camera differ by no more than noise. The images are
 * those of the second moment.
 *
 * \ref trigger takes one shot: it discards the images that the driver has buffered
 * (\ref setDiscardedFrames), then grabs images until the scene stands still. A scene
 * that moves for too long is an error, CameraFault::Moving; so is a recording that
 * ends before the shot is complete. \ref start streams all frames in which the scene
 * stands still, at the nearest rate to \ref setFramesPerSecond; others are dropped. At
 * the end of a recording the stream ends. \ref rewind only resets the frame number.
 *
 * After the cameras were opened, the first images are discarded while automatic
 * exposure and gain settle; then exposure, white balance and focus are fixed, if the
 * camera permits it. Frames are not rectified, and have the colours of the cameras.
 * Each frame is an observation of its own without a pattern. The time stamp is that of
 * the reference camera, the time of the host or the position in a recording.
 *
 * A fault ends the stream, and \ref getError returns a CameraException:
 * Unplugged if a camera gives no more images, Silent if there is none in time. With the
 * next \ref start or \ref trigger the cameras are opened again, recordings at their
 * begin. Time O(pixels) per image, memory
 * of two images per camera.
 * \code
 * pcl::CameraGrabber grabber (pcl::loadTrinocularRig ("rig.yaml"), {"0", "2"});
 * const std::function<pcl::TrinocularGrabber::FrameCallback> see =
 *   [] (const pcl::TrinocularFrame::ConstPtr& frame) { use (*frame); };
 * grabber.registerCallback (see);
 * grabber.trigger ();
 * grabber.wait ();
 * if (grabber.getError ())
 *   std::rethrow_exception (grabber.getError ());
 * \endcode
 * \ingroup video */
class ACMAP_EXPORT CameraGrabber : public acmap::StreamedGrabber {
public:
  using Ptr = shared_ptr<CameraGrabber>;

  /** \brief Opens the cameras, requests images of the rig's size, and grabs one image of
   * each.
   * \param[in] rig geometry of the frames; a baseline of 0 means that this camera does
   * not exist
   * \param[in] devices one for each camera of the rig, in the order reference,
   * horizontal, vertical; see \ref openVideo
   * \param[in] opener opens a device
   * \throws BadArgumentException if the rig is invalid or has another number of cameras,
   * if two devices are the same, or if two cameras give the same image
   * \throws CameraException as \ref openVideo; Unsupported if the images do not have the
   * size of the rig; Silent or Unplugged if a camera gives none
   * \throws InputFileException as \ref openVideo */
  CameraGrabber(const TrinocularRig& rig,
                const std::vector<std::string>& devices,
                VideoOpener opener = openVideo);

  /** \brief Stops the stream. Must not be called from a callback. */
  ~CameraGrabber() noexcept override;

  /** \brief Sets the rate of the next stream, in Hz (default: that of the cameras). The
   * nearest rate is used that is the cameras' rate divided by an integer.
   * \throws BadArgumentException unless within [0.001, 1000] */
  void
  setFramesPerSecond(float frames_per_second);

  /** \brief Sets how many images are discarded after the cameras were opened (default
   * 10).
   * \throws BadArgumentException above 10000 */
  void
  setWarmUpFrames(unsigned frames);

  unsigned
  getWarmUpFrames() const;

  /** \brief Sets how many images are discarded after each \ref trigger (default 5, the
   * four that OpenCV buffers of a V4L2 camera, and one whose exposure has begun).
   * \throws BadArgumentException above 1000 */
  void
  setDiscardedFrames(unsigned frames);

  unsigned
  getDiscardedFrames() const;

  /** \brief Sets how much two successive images may differ while the scene stands
   * still, in grey levels (default 4): the mean of at most 1 % of all blocks of 8 x 8
   * pixels may change by more. 255 switches the check off.
   * \throws BadArgumentException unless within (0, 255] */
  void
  setMaximumChange(double levels);

  double
  getMaximumChange() const;

  /** \brief Sets how many further images a \ref trigger takes while the scene moves,
   * before it is an error (default 60).
   * \throws BadArgumentException above 100000 */
  void
  setMaximumRetries(unsigned images);

  unsigned
  getMaximumRetries() const;

  /** \brief Sets how long to wait for an image, in seconds (default 5).
   * \throws BadArgumentException unless within [0.01, 600] */
  void
  setTimeout(double seconds);

  double
  getTimeout() const;

  /** \brief Sets the format in which the cameras send their images, for example `MJPG`
   * or `YUYV`; empty (default): as the cameras are set. The cameras are opened again
   * before the next frame.
   * \throws BadArgumentException unless empty or four printable characters */
  void
  setPixelFormat(const std::string& format);

  std::string
  getPixelFormat() const;

  /** \brief Sets a fixed exposure of all cameras, in seconds; by default, the exposure
   * that each of them had after the warm-up is kept. Takes effect with the next stream;
   * if a camera refuses it, the stream ends with CameraFault::Unsupported.
   * \throws BadArgumentException unless within [1e-6, 60] */
  void
  setExposure(double seconds);

  /** \brief Leaves the exposure to the cameras, or fixes the one that they have after
   * the warm-up (default: false). */
  void
  setAutomaticExposure(bool is_automatic);

  /** \brief Sets the gain of all cameras, in units of their driver; by default it is
   * not changed. As \ref setExposure.
   * \throws BadArgumentException unless within [-1e6, 1e6] */
  void
  setGain(double gain);

  void
  start() override;

  void
  stop() override;

  /** \brief Takes one more shot; does nothing while a stream runs. Returns at once. */
  void
  trigger() override;

  /** \brief Resets the frame number to 0; a recording continues where it is. */
  void
  rewind() override;

  /** \brief Rate of a stream, Hz. */
  float
  getFramesPerSecond() const override;

  TrinocularRig
  getRig() const override;

  /** \brief May be called while it streams. */
  CameraGrabberReport
  getReport() const;

private:
  acmap::StreamThread&
  stream() const override;

  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
