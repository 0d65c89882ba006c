#pragma once

#include <pcl/stereo/matched_disparity.h>

#include <Eigen/Core>

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief Back-projects a pixel with a disparity, metres in the camera frame.
 * \param[in] pixel its index in row-major order */
inline Eigen::Vector3d
pointOf(const TrinocularRig& rig, std::size_t pixel, double disparity)
{
  const auto width = static_cast<std::size_t>(rig.width);
  const double depth = rig.focal_length * disparityBaseline(rig) / disparity;
  const Eigen::Vector3d ray(
      (static_cast<double>(pixel % width) - rig.center_x) / rig.focal_length,
      (static_cast<double>(pixel / width) - rig.center_y) / rig.focal_length,
      1.0);
  return depth * ray;
}

} // namespace pcl::acmap::bench
