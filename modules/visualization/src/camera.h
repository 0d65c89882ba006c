#pragma once

#include <pcl/visualization/mesh_snapshot.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace pcl::acmap {

constexpr double degree = M_PI / 180; // radians

/** \brief A camera; orthographic if parallel_height is set, else perspective. */
struct Camera {
  Eigen::Vector3d position;
  Eigen::Vector3d focus;
  Eigen::Vector3d up;
  double view_angle;          ///< degrees, vertical
  double near;                ///< near clipping distance along the view, metres
  double far;                 ///< far clipping distance along the view, metres
  double parallel_height = 0; ///< height of an orthographic picture, metres
  Eigen::Vector3d vertical =
      Eigen::Vector3d::Zero(); ///< upwards in the scene; zero: up
};

/** \brief Chooses a camera for points.
 * \param[in] points to be seen, in metres
 * \param[in] facing mean normal of the surface; zero if there is none
 * \throws BadArgumentException when the view has an invalid size or direction */
Camera
placeCamera(const std::vector<Eigen::Vector3f>& points,
            const Eigen::Vector3d& facing,
            const SceneView& view);

/** \brief As above for a given viewing direction and up direction; the camera is moved
 * back until the points fit, unless the view sets its position. */
Camera
lookAlong(const std::vector<Eigen::Vector3f>& points,
          const Eigen::Vector3d& direction,
          const Eigen::Vector3d& up,
          const SceneView& view);

/** \brief Rotates a direction by yaw about the vertical, then downwards by pitch.
 * Radians. */
Eigen::Vector3d
turned(const Eigen::Vector3d& direction,
       const Eigen::Vector3d& up,
       double yaw,
       double pitch);

/** \throws BadArgumentException when the view has an invalid size or direction */
void
requireSound(const SceneView& view);

} // namespace pcl::acmap
