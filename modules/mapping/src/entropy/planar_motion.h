#pragma once

#include <Eigen/Core>

#include <cmath>

namespace pcl::acmap {

/** \brief A pose (x, z, theta) at work: its sine and cosine are taken once. */
class PlanarMotion {
public:
  explicit PlanarMotion(const Eigen::Vector3d& pose)
  : cosine_(std::cos(pose[2]))
  , sine_(std::sin(pose[2]))
  , pose_(pose)
  {}

  /** \brief (X, Z) in the map of (x, z). */
  Eigen::Vector2d
  place(double x, double z) const
  {
    return {cosine_ * x + sine_ * z + pose_[0], cosine_ * z - sine_ * x + pose_[1]};
  }

  /** \brief d (X, Z) / d theta. */
  Eigen::Vector2d
  turn(double x, double z) const
  {
    return {cosine_ * z - sine_ * x, -cosine_ * x - sine_ * z};
  }

  /** \brief A direction atan2 (n_z, n_x) in the map; it falls as theta grows. */
  double
  direction(double angle) const
  {
    return angle - pose_[2];
  }

private:
  double cosine_, sine_;
  Eigen::Vector3d pose_;
};

} // namespace pcl::acmap
