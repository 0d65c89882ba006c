#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>

#include <Eigen/Geometry>

#include <cmath>

namespace pcl {

/** \brief Pose of a robot on the floor: a frame in the XZ plane of the map (x right, y
 * down, z forward), with theta about y. It transforms (x, z) to X = cos theta x + sin
 * theta z + p_x, Z = -sin theta x + cos theta z + p_z.
 * \ingroup core */
struct PlanarPose {
  double x = 0, z = 0; ///< metres
  double theta = 0;    ///< radians
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const PlanarPose& pose, Visitor&& visit)
{
  visit({"x", "m"}, pose.x);
  visit({"z", "m"}, pose.z);
  visit({"theta", "rad"}, pose.theta);
}

/** \brief A motion on the floor (the paper's action): the next pose of the robot in the
 * frame of its previous pose. \ingroup core */
struct PlanarAction {
  double dx = 0, dz = 0; ///< metres, in the frame before the motion
  double dtheta = 0;     ///< radians
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const PlanarAction& action, Visitor&& visit)
{
  visit({"dx", "m"}, action.dx);
  visit({"dz", "m"}, action.dz);
  visit({"dtheta", "rad"}, action.dtheta);
}

/** \brief The pose after an action: p_{t+1} = p_t (+) a_t. \ingroup core */
inline PlanarPose
moved(const PlanarPose& pose, const PlanarAction& action)
{
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  return {pose.x + c * action.dx + s * action.dz,
          pose.z - s * action.dx + c * action.dz,
          pose.theta + action.dtheta};
}

/** \brief The action from one pose to another; its rotation is in [-pi, pi].
 * \ingroup core */
inline PlanarAction
actionBetween(const PlanarPose& from, const PlanarPose& to)
{
  const double c = std::cos(from.theta);
  const double s = std::sin(from.theta);
  const double x = to.x - from.x;
  const double z = to.z - from.z;
  return {c * x - s * z,
          s * x + c * z,
          std::remainder(to.theta - from.theta, 2 * 3.14159265358979323846)};
}

/** \brief T_map_robot of a planar pose. \ingroup core */
inline Eigen::Isometry3d
isometryOf(const PlanarPose& pose)
{
  Eigen::Isometry3d T_map_robot(
      Eigen::AngleAxisd(pose.theta, Eigen::Vector3d::UnitY()));
  T_map_robot.translation() << pose.x, 0, pose.z;
  return T_map_robot;
}

/** \brief The planar pose closest to a rigid motion: its x and z, and the rotation
 * about y closest to its rotation; height and tilt are dropped. \ingroup core */
inline PlanarPose
planarPartOf(const Eigen::Isometry3d& T_map_camera)
{
  const Eigen::Matrix3d rotation = T_map_camera.linear();
  return {T_map_camera.translation().x(),
          T_map_camera.translation().z(),
          std::atan2(rotation(0, 2) - rotation(2, 0), rotation(0, 0) + rotation(2, 2))};
}

/** \brief The rotation from a frame with this up direction to one whose y axis points down,
 * as poses on the floor have it; exactly the identity for -y. \ingroup core */
ACMAP_EXPORT Eigen::Quaterniond
uprightRotation(const Eigen::Vector3d& up);

} // namespace pcl
