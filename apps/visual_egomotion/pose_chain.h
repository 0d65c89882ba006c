#pragma once

#include "egomotion_observation.h"

#include <Eigen/Geometry>

#include <deque>
#include <functional>
#include <optional>

namespace pcl::acmap {

/** \brief Joins observations to the last ones that have a pose, one after the other.
 *
 * Each is tried against the one before, then the two posed ones before that; where none
 * works it is lost, and gets no pose. The map is the frame of the first observation that
 * another one could be joined to: until there is a motion, the last three are kept as such
 * beginnings, so that a bad first one does not spoil the rest. Holds three observations. */
class PoseChain {
public:
  /** \brief T_before_now, or nothing where it cannot be told. */
  using Estimate = std::function<std::optional<Eigen::Isometry3d>(
      const EgomotionObservation& now, const EgomotionObservation& before)>;

  /** \brief Told of each observation as soon as it has a pose, in the sequence's order. */
  using Keep = std::function<void(const EgomotionObservation& observation,
                                  const Eigen::Isometry3d& T_map_camera)>;

  PoseChain(Estimate estimate, Keep keep)
  : estimate_(std::move(estimate))
  , keep_(std::move(keep))
  {}

  /** \brief The next observation of the sequence. */
  void
  add(EgomotionObservation now);

private:
  struct Anchor {
    EgomotionObservation observation;
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
      anchors_; ///< the last posed ones, each its own map until it begins
};

} // namespace pcl::acmap
