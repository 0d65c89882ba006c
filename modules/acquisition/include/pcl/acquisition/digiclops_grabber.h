#pragma once

#include <pcl/acquisition/channel_order.h>
#include <pcl/acquisition/iidc_camera.h>
#include <pcl/acquisition/pattern_projector.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/streamed_grabber.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Statistics of a \ref DigiclopsGrabber over all its streams.
 * \ingroup acquisition */
struct DigiclopsGrabberReport : Report {
  std::size_t frames = 0; ///< number of frames that were passed to the callbacks

  /** \brief Number of frames that the camera counted but that did not arrive. Without a
   * frame counter it is estimated from gaps of more than one and a half periods. */
  std::size_t lost = 0;

  std::size_t broken = 0; ///< dropped frames: too short, or with an impossible counter
  std::size_t early = 0;  ///< exposed before their \ref TrinocularGrabber::trigger
  std::size_t restarts = 0; ///< how often a silent stream was restarted

  /** \brief Frames per second that arrived during the last two seconds; 0 if not yet
   * known. */
  double frames_per_second = 0;

  /** \brief Result of the channel order check; empty before the check. */
  std::optional<ChannelOrderCheck> order;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const DigiclopsGrabberReport& report, Visitor&& visit)
{
  visit({"frames"}, report.frames);
  visit({"lost"}, report.lost);
  visit({"broken"}, report.broken);
  visit({"early"}, report.early);
  visit({"restarts"}, report.restarts);
  visit({"frames_per_second", "1/s"}, report.frames_per_second);
  visit({"order_check"}, report.order);
}

/** \brief Grabs frames of a trinocular IIDC camera: the Digiclops, related models and
 * compatible devices. Section II-A of "Active Stereo Based Compact Mapping".
 *
 * The Digiclops itself is connected to an IEEE-1394 bus. This class uses IIDC tunnelled
 * over USB (\ref openUsbBus), or any other implementation of \ref IidcBus;
 * doc/acquisition/digiclops_grabber.md lists what was tested with which camera.
 *
 * \ref start streams at the frame rate that was set. \ref trigger takes one shot that
 * is exposed after the call: it uses the camera's one-shot, or discards the frames that
 * are already in transfer if the camera has no one-shot. Frames are not rectified; they
 * are grey, or in colour if the sensors have a colour filter. Each frame is an
 * observation of its own without a pattern. The frame numbers have gaps where the
 * camera counted frames that did not arrive. A time stamp is the host's time at which
 * the last byte arrived.
 *
 * A stream that becomes silent is restarted, twice at most; broken frames are dropped.
 * Any other fault is an error: the stream ends, and both \ref getError and the second
 * signal report a \ref CameraException. Unplugging is reported within a second.
 * \ref start reopens a camera that was plugged in again, with all its settings. Time
 * O(pixels) per frame, memory of eight frames.
 * \code
 * pcl::DigiclopsGrabber grabber (pcl::loadTrinocularRig ("rig.yaml"));
 * const std::function<pcl::TrinocularGrabber::FrameCallback> see =
 *   [] (const pcl::TrinocularFrame::ConstPtr& frame) { use (*frame); };
 * const std::function<pcl::DigiclopsGrabber::ErrorCallback> fail =
 *   [] (const pcl::CameraException& error) { std::cerr << error.what () << '\n'; };
 * grabber.registerCallback (see);
 * grabber.registerCallback (fail);
 * grabber.start ();
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT DigiclopsGrabber : public acmap::StreamedGrabber {
public:
  using Ptr = shared_ptr<DigiclopsGrabber>;

  /** \brief Signature of the second signal. It is called in the thread of the stream,
   * once per error, after the last frame. */
  using ErrorCallback = void(const CameraException& error);

  /** \brief Maximum number of frames in which the channel order is checked. The check
   * ends earlier if one of them is conclusive. */
  static constexpr int max_order_checks = 3;

  /** \brief Opens a USB camera in the mode that matches the rig's size and number of
   * cameras, at 14 frames per second (the rate of the paper) or the nearest rate.
   * \param[in] rig geometry of the frames; a baseline of 0 means that this camera does
   * not exist
   * \param[in] device as in \ref openUsbBus
   * \throws BadArgumentException if the rig is invalid
   * \throws CameraException as \ref openUsbBus, \ref IidcCamera::open and
   * \ref IidcCamera::findMode */
  explicit DigiclopsGrabber(const TrinocularRig& rig, const std::string& device = {});

  /** \brief The same on any bus. */
  DigiclopsGrabber(const TrinocularRig& rig, IidcBusOpener opener);

  /** \brief Stops the stream. Must not be called from a callback. */
  ~DigiclopsGrabber() noexcept override;

  /** \brief The camera, for access to its features, its trigger and its identity. Its
   * stream is used by the grabber only. */
  IidcCamera&
  camera();

  /** \brief Sets the mode of the next stream.
   * \throws InitFailedException while the grabber streams
   * \throws BadArgumentException when the mode does not match the rig's size and number
   * of cameras
   * \throws CameraException as \ref IidcCamera::setMode */
  void
  setMode(const IidcMode& mode);

  IidcMode
  getMode() const;

  /** \brief Sets the frame rate of the next stream; the nearest rate of the mode is
   * used.
   * \throws InitFailedException while the grabber streams
   * \throws BadArgumentException unless within [0.001, 1000]
   * \throws CameraException as \ref IidcCamera::setMode */
  void
  setFramesPerSecond(float frames_per_second);

  /** \brief Sets which camera is in which byte. An order that was set is checked, but
   * never replaced. If none is set, it is right, left, top until the check of a stream
   * finds another one.
   * \throws BadArgumentException when a camera occurs twice */
  void
  setChannelOrder(const ChannelOrder& order);

  ChannelOrder
  getChannelOrder() const;

  /** \brief Sets the calibration of the unrectified cameras for the check of the
   * channel order; by default, the cameras of the rig are used.
   * \throws BadArgumentException if the calibration is invalid, has not the rig's size,
   * or lacks a camera of the rig */
  void
  setCalibration(const RigCalibration& calibration);

  /** \brief Sets how long a stream may be silent before it is restarted, in addition to
   * three of its periods, in seconds (default 0.5).
   * \throws BadArgumentException unless within [0.01, 60] */
  void
  setTimeout(double seconds);

  double
  getTimeout() const;

  /** \brief Starts or continues the stream; reopens the camera first if it was lost.
   * \throws CameraException when it cannot be opened */
  void
  start() override;

  void
  stop() override;

  /** \brief Takes one more shot, exposed after this call; does nothing while a stream
   * runs.
   * \throws CameraException when the camera was lost and cannot be opened */
  void
  trigger() override;

  /** \brief Resets the frame number to 0. */
  void
  rewind() override;

  /** \brief The frame rate that the camera was set to. */
  float
  getFramesPerSecond() const override;

  TrinocularRig
  getRig() const override;

  /** \brief The fault that ended the last stream; None if there was no error or if a
   * callback threw another exception. */
  CameraFault
  getFault() const;

  /** \brief May be called while it streams. */
  DigiclopsGrabberReport
  getReport() const;

private:
  acmap::StreamThread&
  stream() const override;

  struct State;
  std::unique_ptr<State> state_;
};

/** \brief Lets a camera check the order of its channels under patterns, which provide corners
 * everywhere: up to \ref DigiclopsGrabber::max_order_checks shots, until it is certain. Then
 * its first frame is the next one, and the projector is dark.
 * \param[in] camera of three cameras, which does not stream
 * \param[in] patterns of the projector's size
 * \param[in] idle called while it waits; what it throws ends the check
 * \return that of the last shot; nothing without patterns
 * \throws what camera and projector throw \ingroup acquisition */
ACMAP_EXPORT std::optional<ChannelOrderCheck>
checkChannelOrder(DigiclopsGrabber& camera,
                  PatternProjector& projector,
                  const std::vector<RgbImage>& patterns,
                  const std::function<void()>& idle = {});

} // namespace pcl
