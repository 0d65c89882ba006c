#pragma once

#include "odometry_view.h"

#include <Eigen/Geometry>

#include <deque>
#include <functional>
#include <optional>

namespace pcl::acmap {

/** \brief Joins views to the last ones that have a pose, one after the other.
 *
 * Each view is tried against the one before, then against the two posed ones before that;
 * if no motion is found it is lost, and gets no pose. The map is the frame of the first
 * view that another one could be joined to: until there is a motion, the last three views
 * are kept as possible beginnings, so that a bad first one does not spoil the rest. Holds
 * three views. */
class PoseChain {
public:
  /** \brief Gives T_before_now, or nothing if the motion is not known. */
  using Estimate = std::function<std::optional<Eigen::Isometry3d>(
      const OdometryView& now, const OdometryView& before)>;

  /** \brief Gets each view as soon as it has a pose, in the order of the sequence. */
  using Keep = std::function<void(const OdometryView& view,
                                  const Eigen::Isometry3d& T_map_camera)>;

  PoseChain(Estimate estimate, Keep keep)
  : estimate_(std::move(estimate))
  , keep_(std::move(keep))
  {}

  /** \brief Adds the next view of the sequence. */
  void
  add(OdometryView now);

private:
  struct Anchor {
    OdometryView view;
    Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  };

  void
  beginWith(Anchor first);

  void
  hold(Anchor anchor);

  Estimate estimate_;
  Keep keep_;
  bool has_begun_ = false;
  std::deque<Anchor>
      anchors_; ///< the last posed views; until it begins, possible firsts
};

} // namespace pcl::acmap
