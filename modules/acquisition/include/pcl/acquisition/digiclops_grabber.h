#pragma once

#include <pcl/acquisition/channel_order.h>
#include <pcl/acquisition/iidc_camera.h>
#include <pcl/core/report.h>
#include <pcl/core/trinocular_grabber.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace pcl {

/** \brief What a \ref DigiclopsGrabber tells of all its streams. \ingroup acquisition */
struct DigiclopsGrabberReport : Report {
  std::size_t frames = 0; ///< that were given

  /** \brief Frames the camera counted that did not come; without a counter: gaps between
   * frames that are longer than one and a half periods. */
  std::size_t lost = 0;

  std::size_t broken = 0; ///< short, or with a counter that no frame can have; left out
  std::size_t early = 0;  ///< exposed before their \ref TrinocularGrabber::trigger
  std::size_t restarts = 0; ///< of a stream that had fallen silent

  /** \brief Frames a second that came, over the last two seconds; 0 before. */
  double frames_per_second = 0;

  /** \brief Of the check of the channel order; nothing before it. */
  std::optional<ChannelOrderCheck> order;
};

/** \brief Frames of a trinocular camera that speaks IIDC: the Digiclops, its siblings and
 * what behaves like them. Section II-A of "Active Stereo Based Compact Mapping".
 *
 * The Digiclops itself hangs on an IEEE-1394 bus. This speaks IIDC as it is tunnelled
 * over USB (\ref openUsbBus), or over any \ref IidcBus of yours; see
 * doc/acquisition/digiclops_grabber.md for what was tried with what.
 *
 * \ref start streams, at the rate that was set; \ref trigger takes one shot, exposed after
 * the call: by the camera's one-shot, or where it has none by leaving out the frames that
 * were under way. Frames are as the cameras see them, grey or, of sensors under a colour
 * filter, in colour; each is an observation of its own without a pattern. Numbers have
 * gaps where the camera counted frames that did not come. Stamps are the host's time of
 * the last byte.
 *
 * A stream that falls silent is begun again, twice; broken frames are left out. What
 * remains is an error: the stream ends, and both \ref getError and the second signal tell
 * it as a \ref CameraException. Unplugging is told within a second. \ref start opens a
 * camera that is back, with all its settings. Time O(pixels) a frame, memory eight frames.
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
class ACMAP_EXPORT DigiclopsGrabber : public TrinocularGrabber {
public:
  using Ptr = shared_ptr<DigiclopsGrabber>;

  /** \brief Signature of the second signal; called in the thread of the stream, once an
   * error, after the last frame. */
  using ErrorCallback = void(const CameraException& error);

  /** \brief The channel order is looked for in so many frames, unless one decides. */
  static constexpr int most_order_checks = 3;

  /** \brief Opens a camera on the USB, in the mode of the rig's size and number of
   * cameras, at 14 frames a second (the paper's) or what comes nearest.
   * \param[in] rig of the frames; a baseline of 0 says that there is no such camera
   * \param[in] device as \ref openUsbBus takes it
   * \throws BadArgumentException for a rig that no camera can have
   * \throws CameraException as \ref openUsbBus, \ref IidcCamera::open and
   * \ref IidcCamera::findMode */
  explicit DigiclopsGrabber(const TrinocularRig& rig, const std::string& device = {});

  /** \brief Likewise on any bus. */
  DigiclopsGrabber(const TrinocularRig& rig, IidcBusOpener opener);

  /** \brief Stops. Not to be called from a callback. */
  ~DigiclopsGrabber() noexcept override;

  /** \brief For features, trigger and who it is. Its stream is the grabber's. */
  IidcCamera&
  camera();

  /** \brief The mode of the next stream.
   * \throws InitFailedException while it streams
   * \throws BadArgumentException when it is not of the rig's size and number of cameras
   * \throws CameraException as \ref IidcCamera::setMode */
  void
  setMode(const IidcMode& mode);

  IidcMode
  getMode() const;

  /** \brief The rate of the next stream; the nearest one that the mode has is taken.
   * \throws InitFailedException while it streams
   * \throws BadArgumentException unless within [0.001, 1000]
   * \throws CameraException as \ref IidcCamera::setMode */
  void
  setFramesPerSecond(float frames_per_second);

  /** \brief Which camera is in which byte, for certain: it is checked, not replaced. Not
   * set, it is right, left, top until the check of a stream finds another one.
   * \throws BadArgumentException when a camera is in it twice */
  void
  setChannelOrder(const ChannelOrder& order);

  ChannelOrder
  getChannelOrder() const;

  /** \brief The cameras as they are built, for the check of the channel order; without,
   * those of the rig.
   * \throws BadArgumentException for cameras that cannot be, not of the rig's size, or
   * when one of the rig's is missing */
  void
  setCalibration(const RigCalibration& calibration);

  /** \brief How long a stream may be silent before it is begun again, beyond three of its
   * periods (default 0.5 s).
   * \throws BadArgumentException unless within [0.01, 60] */
  void
  setTimeout(double seconds);

  double
  getTimeout() const;

  /** \brief Streams on; opens the camera first where it was lost.
   * \throws CameraException when it cannot be opened */
  void
  start() override;

  void
  stop() override;

  /** \brief One more shot, exposed after this call; none while a stream runs.
   * \throws CameraException when it was lost and cannot be opened */
  void
  trigger() override;

  /** \brief Numbers of frames begin at 0 again. */
  void
  rewind() override;

  void
  wait() override;

  bool
  isRunning() const override;

  /** \brief "DigiclopsGrabber". */
  std::string
  getName() const override;

  /** \brief What the camera was set to. */
  float
  getFramesPerSecond() const override;

  TrinocularRig
  getRig() const override;

  std::exception_ptr
  getError() const override;

  /** \brief What is wrong: of the error that ended the last stream, None while it is fine
   * or when a callback threw something else. */
  CameraFault
  getFault() const;

  /** \brief May be called while it streams. */
  DigiclopsGrabberReport
  getReport() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
