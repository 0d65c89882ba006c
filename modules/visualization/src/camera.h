#pragma once

#include <pcl/visualization/mesh_snapshot.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace pcl::acmap {

constexpr double degree = M_PI / 180; // radians

/** \brief A camera, perspective unless it has a height in metres. */
struct Camera {
  Eigen::Vector3d position;
  Eigen::Vector3d focus;
  Eigen::Vector3d up;
  double view_angle;          ///< degrees, vertical
  double near;                ///< metres along the view; what is nearer is not drawn
  double far;                 ///< metres along the view; what is farther is not drawn
  double parallel_height = 0; ///< metres of the picture's height without perspective
};

/** \brief Where to look at points from.
 * \param[in] points what is to be seen, in metres
 * \param[in] facing where the surface looks to on the whole; zero where it has no side
 * \throws BadArgumentException when the view has a size or a direction that cannot be */
Camera
placeCamera(const std::vector<Eigen::Vector3f>& points,
            const Eigen::Vector3d& facing,
            const SceneView& view);

/** \brief The same where one knows which way is up and whither to look; the eye goes so
 * far back that the points fit, unless the view has a place for it. */
Camera
lookAlong(const std::vector<Eigen::Vector3f>& points,
          const Eigen::Vector3d& direction,
          const Eigen::Vector3d& up,
          const SceneView& view);

/** \brief A direction turned about the vertical and then downwards. Radians. */
Eigen::Vector3d
turned(const Eigen::Vector3d& direction,
       const Eigen::Vector3d& up,
       double yaw,
       double pitch);

/** \throws BadArgumentException when the view has a size or a direction that cannot be */
void
requireSound(const SceneView& view);

} // namespace pcl::acmap
