#include <pcl/core/rig_calibration.h>

#include <pcl/core/rig_cameras.h>

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
  vertical.T_reference_camera.translation().y() = rig.baseline_vertical;
  for (const RigCamera camera : acmap::rig_cameras)
    calibration.camera(camera).is_there = acmap::hasCamera(rig, camera);
  return calibration;
}

} // namespace pcl
