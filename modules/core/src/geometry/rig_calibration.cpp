#include <pcl/core/exceptions.h>
#include <pcl/core/rig_calibration.h>

#include "files/rig_text.h"
#include "files/text_number.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/core/trajectory.h>

#include <algorithm>
#include <limits>

namespace pcl {

namespace {

/** \brief A point of the plane z = 1 after distortion, and its derivative with respect
 * to the undistorted point. */
struct Distorted {
  Eigen::Vector2d point;
  Eigen::Matrix2d jacobian;
};

/** \brief Applies the Brown-Conrady model. */
Distorted
distort(const std::array<double, 5>& distortion, const Eigen::Vector2d& point)
{
  const auto [k1, k2, p1, p2, k3] = distortion;
  const double x = point.x();
  const double y = point.y();
  const double r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = 2.0 * (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3));
  Distorted distorted;
  distorted.point << x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
      y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y;
  const double mixed = x * y * slope + 2.0 * (p1 * x + p2 * y);
  distorted.jacobian << radial + x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x, mixed,
      mixed, radial + y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x;
  return distorted;
}

Eigen::Vector2d
noPoint()
{
  return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
}

/** \brief Newton's method, starting on the optical axis, where there is no distortion.
 * Steps are limited to the region in which the model can be inverted: beyond its fold a
 * pixel has a second, wrong solution.
 * \return NaN if it does not converge */
Eigen::Vector2d
undistort(const std::array<double, 5>& distortion, const Eigen::Vector2d& goal)
{
  constexpr int max_steps = 100;
  constexpr double arrived = 1e-14; // relative to the focal length
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  Distorted at = distort(distortion, point);
  double fault = goal.norm();
  double share = 1.0;
  for (int i = 0; i < max_steps && fault > arrived; ++i) {
    const Eigen::Vector2d step = at.jacobian.inverse() * (goal - at.point);
    const Eigen::Vector2d next = point + share * step;
    const Distorted there = distort(distortion, next);
    const double next_fault = (goal - there.point).norm();
    if (!(there.jacobian.determinant() > 0.0) || !(next_fault < fault)) {
      share *= 0.5;
      continue;
    }
    point = next;
    at = there;
    fault = next_fault;
    share = std::min(1.0, 2.0 * share);
  }
  // The last digits may not converge any more.
  return fault <= 1e-12 * (1.0 + goal.norm()) ? point : noPoint();
}

void
requireSoundCamera(const std::string& name,
                   const CameraCalibration& camera,
                   bool is_reference)
{
  using acmap::requireInRange;
  constexpr double farthest_center = 1e6;
  const auto inPixels =
      [&](const char* key, double value, double minimum, double maximum) {
        requireInRange(name + ": " + key, value, minimum, maximum, "px");
      };
  inPixels("focal_x", camera.focal_x, 1.0, acmap::longest_camera_focal_length);
  inPixels("focal_y", camera.focal_y, 1.0, acmap::longest_camera_focal_length);
  inPixels("center_x", camera.center_x, -farthest_center, farthest_center);
  inPixels("center_y", camera.center_y, -farthest_center, farthest_center);
  const double maximum = acmap::largest_camera_distortion;
  for (const double value : camera.distortion)
    requireInRange(name + ": distortion", value, -maximum, maximum, "(no unit)");
  const std::string fault =
      acmap::faultOfPlace(camera.T_reference_camera, is_reference);
  if (!fault.empty())
    throw acmap::BadArgument(name + ": pose " + fault);
}

} // namespace

Eigen::Vector3d
pixelRay(const CameraCalibration& camera, const Eigen::Vector2d& pixel)
{
  const Eigen::Vector2d goal((pixel.x() - camera.center_x) / camera.focal_x,
                             (pixel.y() - camera.center_y) / camera.focal_y);
  return undistort(camera.distortion, goal).homogeneous().normalized();
}

Eigen::Vector2d
projectPoint(const CameraCalibration& camera, const Eigen::Vector3d& point)
{
  if (!(point.z() > 0.0))
    return noPoint();
  const Eigen::Vector2d seen = distort(camera.distortion, point.hnormalized()).point;
  return {camera.focal_x * seen.x() + camera.center_x,
          camera.focal_y * seen.y() + camera.center_y};
}

RigCalibration
calibrationOf(const TrinocularRig& rig)
{
  RigCalibration calibration;
  calibration.width = rig.width;
  calibration.height = rig.height;
  for (CameraCalibration& camera : calibration.cameras) {
    camera.focal_x = camera.focal_y = rig.focal_length;
    camera.center_x = rig.center_x;
    camera.center_y = rig.center_y;
  }
  CameraCalibration& horizontal = calibration.camera(RigCamera::Horizontal);
  CameraCalibration& vertical = calibration.camera(RigCamera::Vertical);
  horizontal.T_reference_camera.translation().x() = rig.baseline_horizontal;
  horizontal.center_x = rig.center_x_horizontal.value_or(rig.center_x);
  vertical.T_reference_camera.translation().y() = rig.baseline_vertical;
  for (const RigCamera camera : acmap::rig_cameras)
    calibration.camera(camera).is_there = acmap::hasCamera(rig, camera);
  return calibration;
}

std::string
acmap::faultOfPlace(const Eigen::Isometry3d& T_reference_camera, bool is_reference)
{
  if (is_reference)
    return T_reference_camera.matrix() == Eigen::Matrix4d::Identity()
               ? ""
               : "must be the identity";
  constexpr double all_digits = 1e-6; // what a calibration prints; used as it is
  if (!isRigid(T_reference_camera, all_digits) ||
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
    throw acmap::BadArgument("the rig has no reference camera");
  for (std::size_t i = 0; i < calibration.cameras.size(); ++i)
    if (calibration.cameras[i].is_there)
      requireSoundCamera(acmap::camera_keys[i], calibration.cameras[i], i == 0);
}

} // namespace pcl
