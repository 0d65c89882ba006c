#pragma once

#include <pcl/stereo/active_stereo_grabber.h>

#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Collects the frames of an observation and makes a cloud of them when it is over.
 * Frames come one after another, though from several threads; only the report may be read
 * meanwhile. */
class ObservationMaker {
public:
  using Give = std::function<void(const ActiveStereoObservation&)>;

  /** \param[in] give takes observations; what it throws passes through */
  ObservationMaker(const TrinocularRig& rig, Give give);

  DisparityFusion&
  fusion()
  {
    return fusion_;
  }

  DisparityBackProjection&
  backProjection()
  {
    return projection_;
  }

  /** \brief The report is of what comes from now on. */
  void
  clearReport();

  /** \brief The next frame comes after a break. */
  void
  resume();

  /** \brief Whether none came since. */
  bool
  isAfterBreak() const
  {
    return is_after_break_;
  }

  /** \brief Takes a frame; when it is the first one of another observation, that before is
   * given. */
  void
  take(const TrinocularFrame::ConstPtr& frame);

  /** \brief No frame is left: the observation is whole, and given. */
  void
  finish();

  /** \brief The observation will never be whole: it is dropped, and so are its later frames
   * where they come after all.
   * \param[in] by what cut it off, for the remark */
  void
  cutOff(const std::string& by);

  ActiveStereoGrabberReport
  report() const;

private:
  using Shots = std::vector<TrinocularFrame::ConstPtr>;

  /** \brief Of a frame in its session. */
  struct Place {
    std::int32_t observation = 0;
    std::uint64_t number = 0;
  };

  bool
  isLeftOver(const TrinocularFrame& frame);

  /** \brief With this frame an observation begins, and one that there was is over. */
  void
  begin(const TrinocularFrame::ConstPtr& frame, bool is_after_break);

  void
  give(const Shots& shots);

  void
  fill(const Shots& shots);

  void
  remark(const std::string& text);

  void
  addSeconds(const Report& step);

  const Give give_;
  DisparityFusion fusion_;
  DisparityBackProjection projection_;
  Shots shots_;              // of the observation that is not over
  std::optional<Place> cut_; // the last frame of the one that was cut off
  bool is_after_break_ = true;

  mutable std::mutex mutex_; // of the report
  ActiveStereoGrabberReport report_;
};

} // namespace pcl::acmap
