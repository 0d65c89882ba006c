#pragma once

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>

namespace pcl {

/** \brief How a bag is read: what its user states of it. \ingroup pipeline */
struct BagSettings {
  /** \brief Take each n-th observation or scan only, at least 1. */
  std::size_t every = 1;

  /** \brief Pose of the sensor on what moves, metres, for a bag whose transforms do not have
   * it: both with x ahead, y left, z up. A frame that is named as optical has the axes of a
   * camera that looks ahead there. */
  std::optional<Eigen::Isometry3d> T_robot_sensor{};

  /** \brief Do not take the poses of the bag. */
  bool ignores_poses = false;
};

} // namespace pcl
