#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/pipeline/session_truth.h>

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace pcl::acmap {

/** \brief A found plane in the frame of the truth. */
struct PlacedPlane {
  Eigen::Vector4d coefficients = Eigen::Vector4d::UnitZ();
  /** Fans of its rims and holes, counter-clockwise or clockwise seen from the side the
   * normal points to: their areas with their signs add up to that of any part. */
  std::vector<std::array<Eigen::Vector3d, 3>> fans;
  double area = 0; ///< square metres
};

PlacedPlane
placed(const PlanePatch& plane, const Eigen::Isometry3d& T_truth_map);

/** \brief The part of a found plane that lies on the rectangles of a true one, along that
 * one's normal. */
struct PlaneOverlap {
  double area = 0; ///< square metres, of the found plane
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< of that area
};

PlaneOverlap
overlapOf(const PlacedPlane& found, const TruePlane& truth);

} // namespace pcl::acmap
