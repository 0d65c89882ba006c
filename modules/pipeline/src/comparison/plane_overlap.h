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
  /** Triangle fans of its outer and inner rims, counter-clockwise or clockwise seen
   * from the side that the normal points to: the signed areas of any part add up to its
   * area. */
  std::vector<std::array<Eigen::Vector3d, 3>> fans;
  double area = 0; ///< square metres
};

PlacedPlane
placed(const PlanePatch& plane, const Eigen::Isometry3d& T_truth_map);

/** \brief The part of a found plane that is on the rectangles of a true one, projected
 * along the normal of the true one. */
struct PlaneOverlap {
  double area = 0; ///< square metres, of the found plane
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< centroid of that area
};

PlaneOverlap
overlapOf(const PlacedPlane& found, const TruePlane& truth);

/** \brief Area of a true plane that found planes cover together, projected along its normal, in
 * squares of 2 cm.
 * \return square metres */
double
coverOf(const std::vector<PlacedPlane>& found, const TruePlane& truth);

} // namespace pcl::acmap
