#pragma once

#include <pcl/egomotion/egomotion_kernel.h>

#include <Eigen/Core>

#include <optional>

namespace pcl::acmap {

/** \brief Projection of points into a camera. */
struct Pinhole {
  Eigen::Vector2d focal_length = Eigen::Vector2d::Zero(); ///< pixels
  Eigen::Vector2d center = Eigen::Vector2d::Zero();       ///< pixels

  /** \param[in] point in front of the camera, z > 0 \return column, row */
  Eigen::Vector2d
  project(const Eigen::Vector3d& point) const
  {
    return focal_length.cwiseProduct(point.head<2>() / point.z()) + center;
  }
};

/** \brief Fits the camera of an organized cloud to its points; returns none if they are
 * not on the rays of one pinhole camera. */
std::optional<Pinhole>
fitPinhole(const CameraView& view);

} // namespace pcl::acmap
