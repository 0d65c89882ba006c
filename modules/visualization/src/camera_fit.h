#pragma once

#include "camera.h"

#include <vector>

namespace pcl::acmap {

/** \brief Box of the 2 % to 98 % quantiles of points along each axis. */
struct RobustBox {
  explicit RobustBox(const std::vector<Eigen::Vector3f>& points);

  /** \brief Is a point inside the box enlarged by a factor? */
  bool
  contains(const Eigen::Vector3d& point, double factor) const;

  Eigen::Vector3d middle;
  Eigen::Vector3d half;
};

/** \brief Moves a camera along its viewing direction until the points fit the picture.
 * \param[in,out] camera focus, up (orthogonal to the direction) and view angle are set
 * \param[in] direction of the view
 * \param[in] aspect width of the picture divided by its height
 * \param[in] center may the focus be moved to the centre of the visible points? */
void
fitCamera(Camera& camera,
          const Eigen::Vector3d& direction,
          const std::vector<Eigen::Vector3f>& points,
          const RobustBox& box,
          double aspect,
          bool center);

/** \brief Sets the clipping range so that it contains the points, except far
 * outliers. */
void
setDepths(Camera& camera,
          const std::vector<Eigen::Vector3f>& points,
          const RobustBox& box);

} // namespace pcl::acmap
