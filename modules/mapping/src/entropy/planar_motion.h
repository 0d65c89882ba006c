#pragma once

#include <pcl/core/planar_pose.h>

#include <Eigen/Core>

#include <cmath>

namespace pcl::acmap {

/** \brief A pose with its precomputed sine and cosine. */
class PlanarMotion {
public:
  explicit PlanarMotion(const PlanarPose& pose)
  : cosine_(std::cos(pose.theta))
  , sine_(std::sin(pose.theta))
  , pose_(pose)
  {}

  double
  cosine() const
  {
    return cosine_;
  }

  double
  sine() const
  {
    return sine_;
  }

  /** \brief (X, Z) in the map of (x, z). */
  Eigen::Vector2d
  place(double x, double z) const
  {
    return {cosine_ * x + sine_ * z + pose_.x, cosine_ * z - sine_ * x + pose_.z};
  }

  /** \brief d (X, Z) / d theta. */
  Eigen::Vector2d
  turn(double x, double z) const
  {
    return {cosine_ * z - sine_ * x, -cosine_ * x - sine_ * z};
  }

  Eigen::Matrix2d
  rotation() const
  {
    Eigen::Matrix2d matrix;
    matrix << cosine_, sine_, -sine_, cosine_;
    return matrix;
  }

  /** \brief A direction atan2 (n_z, n_x) in the map; it decreases with increasing
   * theta. */
  double
  direction(double angle) const
  {
    return angle - pose_.theta;
  }

private:
  double cosine_, sine_;
  PlanarPose pose_;
};

/** \brief d (action between two poses) / d (x, z, theta of both).
 * \param[in] from the first pose
 * \param[in] action from it to the second */
inline Eigen::Matrix<double, 3, 6>
partsOfAction(const PlanarPose& from, const PlanarAction& action)
{
  const double c = std::cos(from.theta), s = std::sin(from.theta);
  Eigen::Matrix<double, 3, 6> parts;
  parts << -c, s, -action.dz, c, -s, 0, //
      -s, -c, action.dx, s, c, 0,       //
      0, 0, -1, 0, 0, 1;
  return parts;
}

} // namespace pcl::acmap
