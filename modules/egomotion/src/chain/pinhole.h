#pragma once

#include <pcl/egomotion/egomotion_kernel.h>

#include <Eigen/Core>

#include <optional>

namespace pcl::acmap {

/** \brief Where a camera shows a point. */
struct Pinhole {
  Eigen::Vector2d focal_length = Eigen::Vector2d::Zero(); ///< pixels
  Eigen::Vector2d center = Eigen::Vector2d::Zero();       ///< pixels

  /** \param[in] point before the camera, z > 0 \return column, row */
  Eigen::Vector2d
  project(const Eigen::Vector3d& point) const
  {
    return focal_length.cwiseProduct(point.head<2>() / point.z()) + center;
  }
};

/** \brief The camera that an organized cloud came from, as its points tell; none where
 * they do not lie on the rays of one. */
std::optional<Pinhole>
fitPinhole(const CameraView& view);

} // namespace pcl::acmap
