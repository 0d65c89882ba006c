#pragma once

#include <pcl/egomotion/impl/egomotion_kernel.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief How the depth images of two views fit under a motion. */
struct DepthAgreement {
  double overlap = 0;      ///< share of a view's points that the other saw as well
  double contradicted = 0; ///< share of the points in front of what the other saw,
                           ///< among these and those of \ref overlap
};

/** \brief Compares each view with the depth image of the other: the smaller overlap and
 * the larger contradiction of both. Points behind what the other saw are hidden there
 * and tell nothing. Unlike surface blocks it needs no dense image. O(pixels).
 * \param[in] source, target must have sigmas */
DepthAgreement
compareDepths(const CameraView& source,
              const CameraView& target,
              const Eigen::Isometry3d& T_target_source);

} // namespace pcl::acmap
