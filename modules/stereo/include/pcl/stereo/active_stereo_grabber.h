#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/trinocular_grabber.h>
#include <pcl/stereo/disparity_back_projection.h>
#include <pcl/stereo/disparity_fusion.h>

#include <exception>
#include <memory>
#include <string>

namespace pcl {

/** \brief Report of \ref ActiveStereoGrabber on its stream. \ingroup stereo */
struct ActiveStereoGrabberReport : Report {
  std::size_t frames = 0;       ///< received from the frame grabber
  std::size_t observations = 0; ///< delivered as clouds
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const ActiveStereoGrabberReport& report, Visitor&& visit)
{
  visit({"frames"}, report.frames);
  visit({"observations"}, report.observations);
}

/** \brief One observation, as delivered by \ref ActiveStereoGrabber.
 * \ingroup stereo */
struct ActiveStereoObservation {
  std::int32_t observation = 0; ///< its number, as in its frames
  PointCloud<PointXYZRGBSigma>::ConstPtr cloud;
  shared_ptr<const MatchedDisparity> disparity;
  DisparityFusionReport fusion;
};

/** \brief Turns any grabber of frames (a camera, a recording, a simulation) into a
 * grabber of organized clouds, one per observation. Section II-A of "Active Stereo
 * Based Compact Mapping".
 *
 * Callbacks run one after another: in the thread of the frame grabber when the first
 * frame of the next observation arrives, so that frames wait while an observation is
 * computed; and in a thread of this grabber after the end of the stream. An error,
 * including one thrown by a callback, ends the stream and is stored for \ref getError;
 * no exception leaves a thread. \ref start, \ref stop and \ref wait may be called at
 * any time, any number of times, from any thread and from a callback. Other code must
 * not start or stop the frame grabber in the meantime.
 *
 * The header of a cloud has the stamp of the first frame, the number of the observation
 * as `seq`, and `frame_id` "reference_camera". The sensor is at the origin. A program
 * written for PCL's OpenNIGrabber can register its callbacks here
 * (\ref PointCloudCallback); `sigma` is lost in its point types.
 *
 * An observation is complete when a frame of another observation arrives, or a frame
 * whose number is not greater than the last one, or when the stream ends by itself. An
 * observation that is interrupted by \ref stop or by an error is dropped, and so are
 * those of its frames that arrive later; the report mentions this. If a callback calls
 * \ref stop, nothing is interrupted: the next \ref start continues. A frame grabber of
 * single frames (0 per second) provides one frame with each \ref start; the start that
 * finds no more frames delivers the last observation. For time and memory see
 * \ref DisparityFusion.
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
  /** \brief Signature for clouds, for registerCallback of PCL. PointT is
   * PointXYZRGBSigma, or one of those of OpenNIGrabber, PointXYZ, PointXYZRGB and
   * PointXYZRGBA, to which a cloud is converted if such a callback is connected. */
  template <typename PointT>
  using PointCloudCallback = void(const typename PointCloud<PointT>::ConstPtr& cloud);

  using CloudCallback = PointCloudCallback<PointXYZRGBSigma>;

  using ObservationCallback = void(const ActiveStereoObservation& observation);

  /** \param[in] frames grabber of rectified frames; its rig is used for the fusion and
   * the back-projection
   * \throws BadArgumentException for a null pointer, and for a rig without neighbours
   */
  explicit ActiveStereoGrabber(shared_ptr<TrinocularGrabber> frames);

  /** \brief Stops the stream. Must not be called from a callback. */
  ~ActiveStereoGrabber() noexcept override;

  /** \brief Settings of the fusion; change them before \ref start.
   * \throws InitFailedException while the stream runs */
  DisparityFusion&
  fusion();

  /** \brief Settings of the back-projection; change them before \ref start.
   * \throws InitFailedException while the stream runs */
  DisparityBackProjection&
  backProjection();

  /** \brief Continues from the current position of the frame grabber; does nothing
   * while the stream runs. */
  void
  start() override;

  /** \brief Stops the frame grabber; no callback is called after this has returned. If
   * it is called from a callback, no further observation is delivered. */
  void
  stop() override;

  bool
  isRunning() const override;

  /** \brief Waits until the stream has ended and the last observation was delivered;
   * returns at once if it is called from a callback. */
  void
  wait();

  /** \brief The error that ended the stream; null if it ended without an error or still
   * runs. The next stream resets it. */
  std::exception_ptr
  getError() const;

  /** \brief "ActiveStereoGrabber". */
  std::string
  getName() const override;

  /** \brief Rate of the observations: 0, which means "not fixed" in PCL. */
  float
  getFramesPerSecond() const override;

  TrinocularRig
  getRig() const;

  /** \brief Report of the current or the last stream; seconds are sums over its
   * observations. */
  ActiveStereoGrabberReport
  getReport() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
