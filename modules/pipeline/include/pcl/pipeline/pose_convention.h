#pragma once

#include <pcl/core/export.h>

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <string>

namespace pcl {

/** \brief What the matrices of recorded poses mean. The camera of acmap looks along z, with x to
 * the right and y down; that of OpenGL along -z, with y up. \ingroup pipeline */
enum class PoseConvention {
  CameraToWorld,
  WorldToCamera, ///< the inverse
  OpenGl,        ///< camera to world, axes of OpenGL's camera
  OpenGlWorldToCamera,
  TransposedRotation ///< camera to world, but the rotation is written column by column
};

namespace acmap {

/** \brief Names of options and in reports. */
inline constexpr std::array<const char*, 5> pose_convention_names = {
    "camera-to-world",
    "world-to-camera",
    "opengl",
    "opengl-world-to-camera",
    "transposed-rotation"};

} // namespace acmap

/** \brief How recorded poses are read. \ingroup pipeline */
struct PoseReading {
  PoseConvention convention = PoseConvention::CameraToWorld;
  double scale = 1; ///< metres in a unit of their translations
};

/** \brief The pose T_world_camera, in the axes of acmap's camera and in metres, that a recorded
 * pose means. \ingroup pipeline */
ACMAP_EXPORT Eigen::Isometry3d
readPose(const Eigen::Isometry3d& recorded, const PoseReading& reading);

/** \brief "world-to-camera, millimetres". \ingroup pipeline */
ACMAP_EXPORT std::string
textOf(const PoseReading& reading);

} // namespace pcl
