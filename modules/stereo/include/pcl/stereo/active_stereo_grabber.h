#pragma once

#include <pcl/core/export.h>
#include <pcl/core/report.h>
#include <pcl/core/trinocular_grabber.h>
#include <pcl/stereo/disparity_back_projection.h>
#include <pcl/stereo/disparity_fusion.h>

#include <exception>
#include <memory>
#include <string>

namespace pcl {

/** \brief What \ref ActiveStereoGrabber tells about its stream. \ingroup stereo */
struct ActiveStereoGrabberReport : Report {
  std::size_t frames = 0;       ///< that came from the frame grabber
  std::size_t observations = 0; ///< given as clouds
};

/** \brief One observation, as it comes from an \ref ActiveStereoGrabber.
 * \ingroup stereo */
struct ActiveStereoObservation {
  std::int32_t observation = 0; ///< its number, as its frames have it
  PointCloud<PointXYZRGBSigma>::ConstPtr cloud;
  shared_ptr<const MatchedDisparity> disparity;
  DisparityFusionReport fusion;
};

/** \brief Turns any grabber of frames (a camera, a recording, a simulation) into a grabber
 * of organized clouds, one an observation. Section II-A of "Active Stereo Based Compact
 * Mapping".
 *
 * Callbacks run one after another: in the thread of the frame grabber with the first frame
 * of the next observation, so that frames wait while an observation is made; and after its
 * end in a thread of this one. An error, also one that a callback throws, ends the stream
 * and is kept for \ref getError; no exception leaves a thread. \ref start, \ref stop and
 * \ref wait may be called at any time, any number of times, from any thread and from a
 * callback. The frame grabber must not be started or stopped by others meanwhile.
 *
 * A cloud's header has the first frame's stamp, the observation's number as `seq`, and
 * `frame_id` "reference_camera". Its sensor stands in the origin.
 *
 * An observation is over when a frame of another one comes, or one whose number is not
 * above the last, or when the stream ends by itself. One that \ref stop or an error cuts
 * off is dropped, with those of its frames that come later, which the report tells. A
 * callback that stops cuts nothing off: the next \ref start goes on. A frame grabber of
 * single frames (0 a second) gives one with each \ref start; the start that gets none
 * gives the last observation. Time and memory as \ref DisparityFusion.
 * \code
 * pcl::ActiveStereoGrabber grabber (
 *   std::make_shared<pcl::TrinocularFileGrabber> ("session", 1000.0f));
 * const std::function<pcl::ActiveStereoGrabber::CloudCallback> see =
 *   [] (const pcl::PointCloud<pcl::PointXYZRGBSigma>::ConstPtr& cloud) { use (*cloud); };
 * grabber.registerCallback (see);
 * grabber.start ();
 * grabber.wait ();
 * \endcode
 * \ingroup stereo */
class ACMAP_EXPORT ActiveStereoGrabber : public Grabber {
public:
  /** \brief Signatures of the two signals, for PCL's registerCallback. */
  using CloudCallback = void(const PointCloud<PointXYZRGBSigma>::ConstPtr& cloud);
  using ObservationCallback = void(const ActiveStereoObservation& observation);

  /** \param[in] frames rectified; its rig is that of fusion and back-projection
   * \throws BadArgumentException for none, and for a rig without neighbours */
  explicit ActiveStereoGrabber(shared_ptr<TrinocularGrabber> frames);

  /** \brief Stops. Not to be called from a callback. */
  ~ActiveStereoGrabber() noexcept override;

  /** \brief How disparities are found: set it up before \ref start.
   * \throws InitFailedException while the stream runs */
  DisparityFusion&
  fusion();

  /** \brief How they become points: as above. */
  DisparityBackProjection&
  backProjection();

  /** \brief Streams on from where the frame grabber stands; does nothing while it streams.
   */
  void
  start() override;

  /** \brief Stops the frame grabber; no callback is called after it has returned. From a
   * callback: no other observation is given. */
  void
  stop() override;

  bool
  isRunning() const override;

  /** \brief Waits until the stream has ended and the last observation was given; in a
   * callback it returns at once. */
  void
  wait();

  /** \brief What ended the stream, null when it ended well or still runs; the next stream
   * forgets it. */
  std::exception_ptr
  getError() const;

  /** \brief "ActiveStereoGrabber". */
  std::string
  getName() const override;

  /** \brief Of observations; 0, which PCL has for no fixed rate. */
  float
  getFramesPerSecond() const override;

  TrinocularRig
  getRig() const;

  /** \brief Of this stream, or the last one; seconds are sums over its observations. */
  ActiveStereoGrabberReport
  getReport() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
