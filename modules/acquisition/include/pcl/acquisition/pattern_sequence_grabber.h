#pragma once

#include <pcl/acquisition/pattern_projector.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/streamed_grabber.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace pcl {

namespace acmap {
class SequenceStream;
}

/** \brief Statistics of the last stream of a \ref PatternSequenceGrabber. There is a
 * remark for each observation that was interrupted. \ingroup acquisition */
struct PatternSequenceGrabberReport : Report {
  std::size_t shots = 0;        ///< number of shots that were passed to the callbacks
  std::size_t observations = 0; ///< number of complete observations
  std::size_t spared = 0;       ///< number of patterns that were not needed any more
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const PatternSequenceGrabberReport& report, Visitor&& visit)
{
  visit({"shots"}, report.shots);
  visit({"observations"}, report.observations);
  visit({"spared"}, report.spared);
}

/** \brief Synchronizes a camera and a projector and grabs observations. An observation
 * consists of one shot with the projector off and one under each pattern. Section II-A
 * of "Active Stereo Based Compact Mapping".
 *
 * For each shot the pattern is shown. When the projector has acknowledged it and the
 * settle time has passed, the camera's \ref TrinocularGrabber::trigger takes a shot,
 * whose exposure begins after the call. Therefore no frame contains a mixture of two
 * patterns; \ref measureSettleTime measures the settle time that a projector needs.
 * Shots are numbered from 0, observation and pattern are set by this class, time stamps
 * and images are those of the camera.
 *
 * \ref start streams observations, one after another; \ref observe takes one. An
 * observation that is interrupted by \ref stop or by an error is not continued, since
 * the rig may be moved in the meantime: the next shot is the first one of the following
 * observation. The projector is dark before the first shot and after the end of a
 * stream. Callbacks run in the thread of this grabber, not in that of the camera. While
 * this grabber is used, the camera must not be started or stopped by others, and this
 * grabber must not be started or stopped from a callback of the camera. The error of a
 * stream is what the camera, the projector or a callback has thrown, or a
 * CameraException (CameraFault::Silent) when the camera gave no shot in time.
 * \code
 * pcl::PatternSequenceGrabber grabber (camera, projector, patterns);
 * grabber.registerCallback (record);
 * grabber.observe ();
 * grabber.wait ();
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT PatternSequenceGrabber : public acmap::StreamedGrabber {
public:
  /** \brief Called after each shot under a pattern except the last one, in the thread
   * of the stream and after the callbacks. Returning false ends the observation early.
   * It may do everything that a callback may do. */
  using WantMore = std::function<bool(const TrinocularFrame& frame)>;

  /** \param[in] camera gives one frame for each trigger
   * \param[in] projector only used by the thread of the stream while the grabber
   * streams
   * \param[in] patterns have the projector's size; may be empty
   * \throws BadArgumentException if there is no camera or no projector, or if a pattern
   * is incomplete */
  PatternSequenceGrabber(shared_ptr<TrinocularGrabber> camera,
                         shared_ptr<PatternProjector> projector,
                         std::vector<RgbImage> patterns);

  /** \brief Stops the stream. Must not be called from a callback. */
  ~PatternSequenceGrabber() noexcept override;

  /** \brief Sets the time between the projector's acknowledgement and the shot, in
   * seconds (default 0.1, which includes the delays of a compositor, of the projector
   * and of its lamp).
   * \throws BadArgumentException unless within [0, 10] */
  void
  setSettleTime(double seconds);

  double
  getSettleTime() const;

  /** \brief Sets the maximum time to wait for the camera's shot after its trigger, in
   * seconds (default 5).
   * \throws BadArgumentException unless within [0.01, 600] */
  void
  setShotTimeout(double seconds);

  double
  getShotTimeout() const;

  /** \brief Sets a function that can end an observation early, from the next shot on;
   * empty (default): all patterns are shown. */
  void
  setWantMore(WantMore want_more);

  /** \brief Streams observations, one after another, until \ref stop. */
  void
  start() override;

  /** \brief Takes one more observation, or the rest of an incomplete one; does nothing
   * while observations are streamed without end. Returns immediately. */
  void
  observe();

  /** \brief Ends the stream and interrupts the current observation. Waiting for the
   * settle time or for a shot ends immediately; the camera is stopped, and the
   * projector shows black. After the return no callback is called. When called from a
   * callback, this callback is the last one. */
  void
  stop() override;

  /** \brief Takes only the next shot; does nothing while observations are streamed
   * without end. After the shot the projector is dark. The last shot of an observation
   * completes it. Returns immediately. */
  void
  trigger() override;

  /** \brief The next shot is the first of observation 0. */
  void
  rewind() override;

  /** \brief Returns 0, which in PCL means that there is no fixed rate. */
  float
  getFramesPerSecond() const override;

  TrinocularRig
  getRig() const override;

  /** \brief May be called while it streams. */
  PatternSequenceGrabberReport
  getReport() const;

private:
  acmap::StreamThread&
  stream() const override;

  std::unique_ptr<acmap::SequenceStream> stream_;
};

} // namespace pcl
