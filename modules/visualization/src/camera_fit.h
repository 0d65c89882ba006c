#pragma once

#include "camera.h"

#include <vector>

namespace pcl::acmap {

/** \brief Box of the 2 % to 98 % quantiles of points. */
struct RobustBox {
  explicit RobustBox(const std::vector<Eigen::Vector3f>& points);

  /** \brief Whether a point lies in the box blown up by a factor. */
  bool
  contains(const Eigen::Vector3d& point, double factor) const;

  Eigen::Vector3d middle;
  Eigen::Vector3d half;
};

/** \brief Moves a camera along its view until the points fit the picture.
 * \param[in,out] camera focus, up (upright to the view) and view angle are set
 * \param[in] direction of the view
 * \param[in] aspect width of the picture over its height
 * \param[in] center whether the focus may move to the middle of what is seen */
void
fitCamera(Camera& camera,
          const Eigen::Vector3d& direction,
          const std::vector<Eigen::Vector3f>& points,
          const RobustBox& box,
          double aspect,
          bool center);

/** \brief Sets the range of depths so that it holds the points but no far strays. */
void
setDepths(Camera& camera,
          const std::vector<Eigen::Vector3f>& points,
          const RobustBox& box);

} // namespace pcl::acmap
