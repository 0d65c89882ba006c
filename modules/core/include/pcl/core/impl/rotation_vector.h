#pragma once

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief The rotation of a rotation vector: about its direction, by its length in radians.
 * None for zero. \ingroup core */
inline Eigen::AngleAxisd
rotationOf(const Eigen::Vector3d& vector)
{
  const double angle = vector.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, vector / angle)
                   : Eigen::AngleAxisd::Identity();
}

} // namespace pcl::acmap
