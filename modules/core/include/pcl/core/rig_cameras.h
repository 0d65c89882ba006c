#pragma once

#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <algorithm>
#include <array>

namespace pcl::acmap {

/** \brief All cameras that a rig can have, in their order. \ingroup core */
inline constexpr std::array<RigCamera, 3> rig_cameras = {
    RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};

/** \brief Has the rig this camera? A baseline of 0 means that it has not.
 * \ingroup core */
inline bool
hasCamera(const TrinocularRig& rig, RigCamera camera)
{
  return (camera != RigCamera::Horizontal || rig.baseline_horizontal != 0.0) &&
         (camera != RigCamera::Vertical || rig.baseline_vertical != 0.0);
}

/** \brief Returns the number of cameras of the rig, 1 to 3. \ingroup core */
inline int
countCameras(const TrinocularRig& rig)
{
  return static_cast<int>(
      std::count_if(rig_cameras.begin(), rig_cameras.end(), [&](RigCamera camera) {
        return hasCamera(rig, camera);
      }));
}

/** \brief Disparity by which the principal points of a horizontal pair differ, px: a
 * point at infinity has the negative of it. The depth of a disparity d is focal_length *
 * baseline / (d + offset). \ingroup core */
inline double
disparityOffset(const TrinocularRig& rig)
{
  const double offset = rig.center_x_horizontal.value_or(rig.center_x) - rig.center_x;
  return rig.baseline_horizontal < 0.0 ? -offset : offset;
}

} // namespace pcl::acmap
