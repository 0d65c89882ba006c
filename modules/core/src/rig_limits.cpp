#include "rig_limits.h"

#include "number_text.h"

#include <pcl/core/arguments.h>
#include <pcl/core/trajectory.h>

namespace pcl {

namespace {

void
requireSoundCamera(const std::string& name,
                   const CameraCalibration& camera,
                   bool is_reference)
{
  using acmap::requireInRange;
  constexpr double farthest_center = 1e6;
  const auto inPixels = [&](const char* key, double value, double least, double most) {
    requireInRange(name + ": " + key, value, least, most, "px");
  };
  inPixels("focal_x", camera.focal_x, 1.0, acmap::longest_camera_focal_length);
  inPixels("focal_y", camera.focal_y, 1.0, acmap::longest_camera_focal_length);
  inPixels("center_x", camera.center_x, -farthest_center, farthest_center);
  inPixels("center_y", camera.center_y, -farthest_center, farthest_center);
  const double most = acmap::largest_camera_distortion;
  for (const double value : camera.distortion)
    requireInRange(name + ": distortion", value, -most, most, "(no unit)");
  const std::string fault =
      acmap::faultOfPlace(camera.T_reference_camera, is_reference);
  if (!fault.empty())
    throw BadArgumentException(name + ": pose " + fault);
}

} // namespace

std::string
acmap::faultOfPlace(const Eigen::Isometry3d& T_reference_camera, bool is_reference)
{
  if (is_reference)
    return T_reference_camera.matrix() == Eigen::Matrix4d::Identity()
               ? ""
               : "must be the identity";
  if (!isRigid(T_reference_camera) ||
      T_reference_camera.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    return "is no rigid motion";
  if (T_reference_camera.translation().norm() > longest_camera_baseline)
    return "is more than " + textOf(longest_camera_baseline) +
           " m away from the reference";
  return "";
}

void
requireSoundCalibration(const RigCalibration& calibration)
{
  constexpr double longest_side = acmap::longest_camera_side;
  acmap::requireInRange("width", calibration.width, 1, longest_side, "px");
  acmap::requireInRange("height", calibration.height, 1, longest_side, "px");
  if (!calibration.camera(RigCamera::Reference).is_there)
    throw BadArgumentException("the rig has no reference camera");
  for (std::size_t i = 0; i < calibration.cameras.size(); ++i)
    if (calibration.cameras[i].is_there)
      requireSoundCamera(acmap::camera_keys[i], calibration.cameras[i], i == 0);
}

} // namespace pcl
