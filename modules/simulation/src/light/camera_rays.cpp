#include "camera_rays.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

CameraRays
idealCamera(const TrinocularRig& rig, const Eigen::Vector3d& place)
{
  CameraRays rays;
  rays.width = rig.width;
  rays.height = rig.height;
  rays.T_reference_camera.translation() = place;
  rays.pinhole = rig;
  return rays;
}

/** \brief A pinhole of this focal length, or a shorter one, whose image contains all
 * slopes. */
TrinocularRig
pinholeAround(const std::vector<Eigen::Vector2d>& slopes, double focal_length)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double longest_side = 8192; // px
  Eigen::Array2d minimum(infinity, infinity);
  Eigen::Array2d maximum = -minimum;
  for (const Eigen::Vector2d& slope : slopes)
    if (slope.allFinite()) {
      minimum = minimum.min(slope.array());
      maximum = maximum.max(slope.array());
    }
  if (!(minimum <= maximum).all())
    throw acmap::BadArgument("a camera whose pixels look nowhere: its distortion has "
                             "no inverse");
  TrinocularRig pinhole;
  pinhole.focal_length =
      std::min(focal_length, longest_side / (maximum - minimum).maxCoeff());
  pinhole.center_x = 1.0 - pinhole.focal_length * minimum.x();
  pinhole.center_y = 1.0 - pinhole.focal_length * minimum.y();
  const Eigen::Array2d size = pinhole.focal_length * (maximum - minimum) + 3.0;
  pinhole.width = static_cast<int>(std::ceil(size.x()));
  pinhole.height = static_cast<int>(std::ceil(size.y()));
  return pinhole;
}

Eigen::Vector2d
slopeOf(const CameraCalibration& camera, int column, int row)
{
  const Eigen::Vector3d ray = pixelRay(camera, Eigen::Vector2d(column, row));
  if (ray.z() > 0.0)
    return ray.hnormalized();
  return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
}

CameraRays
builtCamera(const RigCalibration& calibration, const CameraCalibration& camera)
{
  CameraRays rays;
  rays.width = calibration.width;
  rays.height = calibration.height;
  rays.T_reference_camera = camera.T_reference_camera;
  rays.slopes.reserve(static_cast<std::size_t>(rays.width) *
                      static_cast<std::size_t>(rays.height));
  for (int row = 0; row < rays.height; ++row)
    for (int column = 0; column < rays.width; ++column)
      rays.slopes.push_back(slopeOf(camera, column, row));
  rays.pinhole = pinholeAround(rays.slopes, camera.focal_x);
  return rays;
}

} // namespace

RigRays
raysOf(const TrinocularRig& rig)
{
  requireSoundRig(rig);
  RigRays rays;
  rays[0] = idealCamera(rig, Eigen::Vector3d::Zero());
  if (hasCamera(rig, RigCamera::Horizontal))
    rays[1] = idealCamera(rig, {rig.baseline_horizontal, 0, 0});
  if (hasCamera(rig, RigCamera::Vertical))
    rays[2] = idealCamera(rig, {0, rig.baseline_vertical, 0});
  return rays;
}

RigRays
raysOf(const RigCalibration& calibration)
{
  constexpr double longest_side = 8192; // memory is 16 bytes per pixel
  requireSoundCalibration(calibration);
  requireInRange("width", calibration.width, 1, longest_side, "px");
  requireInRange("height", calibration.height, 1, longest_side, "px");
  RigRays rays;
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (calibration.cameras[i].is_there)
      rays[i] = builtCamera(calibration, calibration.cameras[i]);
  return rays;
}

} // namespace pcl::acmap
