#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief A polygon in space, metres: its rim counter-clockwise seen from the side the
 * plane's normal points to, its holes clockwise. \ingroup core */
struct PlanePolygon {
  std::vector<Eigen::Vector3f> outer;
  std::vector<std::vector<Eigen::Vector3f>> holes;
};

/** \brief A plane of a building with all that is known of it. \ingroup core */
struct PlanePatch {
  /** \brief Unit normal, towards the side it was seen from, and offset:
   * a x + b y + c z + d = 0, metres. */
  Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();

  /** \brief Middle of the support, on the plane, and two axes in the plane: the frame of
   * the covariance. axis_u, axis_v and the normal are a right-handed basis. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_u = Eigen::Vector3d::UnitX();
  Eigen::Vector3d axis_v = Eigen::Vector3d::UnitY();

  /** \brief Of (slope along axis_u, slope along axis_v, offset along the normal at the
   * centre); radians and metres. NaN where the support is too small to tell. */
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  std::size_t support = 0;      ///< points
  double effective_support = 0; ///< independent ones among them; NaN as the covariance
  double rms = 0;               ///< metres, of the support about the plane
  double area = 0;              ///< square metres, of the polygons
  std::vector<PlanePolygon> polygons;
};

} // namespace pcl
