#pragma once

#include <pcl/stereo/active_stereo_grabber.h>

#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Collects the frames of an observation and computes a cloud when it is
 * complete. Frames must be passed one after another, but may come from several threads;
 * only the report may be read at the same time. */
class ObservationMaker {
public:
  using Give = std::function<void(const ActiveStereoObservation&)>;

  /** \param[in] give receives the observations; its exceptions are passed on */
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

  /** \brief Clears the report: it covers what follows. */
  void
  clearReport();

  /** \brief Marks that the next frame comes after a break. */
  void
  resume();

  /** \brief Returns true if no frame has come since \ref resume. */
  bool
  isAfterBreak() const
  {
    return is_after_break_;
  }

  /** \brief Adds a frame; if it is the first one of another observation, the previous
   * observation is delivered. */
  void
  take(const TrinocularFrame::ConstPtr& frame);

  /** \brief Must be called after the last frame: delivers the observation. */
  void
  finish();

  /** \brief Drops the incomplete observation, and its frames that may follow.
   * \param[in] by what interrupted it, for the remark */
  void
  cutOff(const std::string& by);

  ActiveStereoGrabberReport
  report() const;

private:
  using Shots = std::vector<TrinocularFrame::ConstPtr>;

  /** \brief Position of a frame in its session. */
  struct Place {
    std::int32_t observation = 0;
    std::uint64_t number = 0;
  };

  bool
  isLeftOver(const TrinocularFrame& frame);

  /** \brief Begins an observation with this frame and delivers the previous one. */
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
  Shots shots_;              // of the current observation
  std::optional<Place> cut_; // last frame of the observation that was interrupted
  bool is_after_break_ = true;

  mutable std::mutex mutex_; // protects the report
  ActiveStereoGrabberReport report_;
};

} // namespace pcl::acmap
