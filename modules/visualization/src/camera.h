#pragma once

#include <pcl/visualization/mesh_snapshot.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A perspective camera. Metres, degrees. */
struct Camera {
  Eigen::Vector3d position;
  Eigen::Vector3d focus;
  Eigen::Vector3d up;
  double view_angle; ///< degrees, vertical
  double near;       ///< metres along the view; what is nearer is not drawn
  double far;        ///< metres along the view; what is farther is not drawn
};

/** \brief Where to look at points from.
 * \param[in] points what is to be seen, in metres
 * \param[in] facing where the surface looks to on the whole; zero where it has no side
 * \throws BadArgumentException when the view has a size or a direction that cannot be */
Camera
placeCamera(const std::vector<Eigen::Vector3f>& points,
            const Eigen::Vector3d& facing,
            const SceneView& view);

} // namespace pcl::acmap
