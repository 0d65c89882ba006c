#pragma once

#include <pcl/acquisition/pattern_projector.h>
#include <pcl/core/report.h>
#include <pcl/core/trinocular_grabber.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace pcl {

namespace acmap {
class SequenceStream;
}

/** \brief What a \ref PatternSequenceGrabber tells of its last stream; observations that
 * were cut off have a remark. \ingroup acquisition */
struct PatternSequenceGrabberReport : Report {
  std::size_t shots = 0;        ///< that were given
  std::size_t observations = 0; ///< that were finished
  std::size_t spared = 0;       ///< patterns that were not needed any more
};

/** \brief A camera and a projector in step: observations, each of a shot with the
 * projector off and one under each pattern. Section II-A of "Active Stereo Based
 * Compact Mapping".
 *
 * For each shot the pattern is shown; when the projector has acknowledged it, and the
 * settle time has passed, the camera's \ref TrinocularGrabber::trigger takes a shot,
 * which begins its exposure after the call. So no frame mixes two patterns; how long a
 * projector needs, \ref measureSettleTime finds. Numbers of shots go on from 0,
 * observation and pattern are set, stamps and images are the camera's.
 *
 * \ref start streams observations, one after another; \ref observe takes one. An
 * observation under way that \ref stop or an error cuts off is not finished, as the rig
 * may be moved then: the next shot is the first of the one after it. The projector is
 * dark before the first shot, and when a stream has ended. Callbacks run in the thread
 * of this grabber, not in the camera's. The camera must not be started or stopped by
 * others meanwhile, nor this one from a callback of the camera.
 * \code
 * pcl::PatternSequenceGrabber grabber (camera, projector, patterns);
 * grabber.registerCallback (record);
 * grabber.observe ();
 * grabber.wait ();
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT PatternSequenceGrabber : public TrinocularGrabber {
public:
  /** \brief Asked after each shot under a pattern, but the last one, in the thread of
   * the stream and after the callbacks: false ends the observation early. It may do
   * what a callback may. */
  using WantMore = std::function<bool(const TrinocularFrame& frame)>;

  /** \param[in] camera gives one frame for each trigger
   * \param[in] projector used by the thread of the stream alone, while it streams
   * \param[in] patterns of the projector's size; may be none
   * \throws BadArgumentException for no camera, no projector, a pattern that has not
   * all its values */
  PatternSequenceGrabber(shared_ptr<TrinocularGrabber> camera,
                         shared_ptr<PatternProjector> projector,
                         std::vector<RgbImage> patterns);

  /** \brief Stops. Not to be called from a callback. */
  ~PatternSequenceGrabber() noexcept override;

  /** \brief Time from the projector's acknowledgement to the shot, seconds (default 0.1:
   * a compositor, the projector's own delay, and its lamp).
   * \throws BadArgumentException unless within [0, 10] */
  void
  setSettleTime(double seconds);

  double
  getSettleTime() const;

  /** \brief Longest wait for the camera's shot, from its trigger, seconds (default 5).
   * \throws BadArgumentException unless within [0.01, 600] */
  void
  setShotTimeout(double seconds);

  double
  getShotTimeout() const;

  /** \brief From the next shot on; none (default): all patterns are shown. */
  void
  setWantMore(WantMore want_more);

  /** \brief Streams observations, one after another, until \ref stop. */
  void
  start() override;

  /** \brief Takes one observation more, or the rest of the one under way; none while
   * observations stream without end. Returns at once. */
  void
  observe();

  /** \brief Ends the stream, and cuts off the observation under way. Settling and the
   * wait for a shot end at once; the camera is stopped, the projector shows black. No
   * callback is called after it has returned. From a callback: this callback is the
   * last one. */
  void
  stop() override;

  /** \brief Takes the next shot alone; none while observations stream without end. After
   * it the projector is dark; with the last shot of an observation it is finished.
   * Returns at once. */
  void
  trigger() override;

  /** \brief The next shot is the first of observation 0. */
  void
  rewind() override;

  void
  wait() override;

  bool
  isRunning() const override;

  /** \brief "PatternSequenceGrabber". */
  std::string
  getName() const override;

  /** \brief 0, which PCL has for no fixed rate. */
  float
  getFramesPerSecond() const override;

  TrinocularRig
  getRig() const override;

  /** \brief What ended the stream: of camera, projector or a callback; CameraException
   * (CameraFault::Silent) when the camera gave no shot in time. */
  std::exception_ptr
  getError() const override;

  /** \brief May be called while it streams. */
  PatternSequenceGrabberReport
  getReport() const;

private:
  std::unique_ptr<acmap::SequenceStream> stream_;
};

} // namespace pcl
