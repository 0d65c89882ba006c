#include "common_view.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>

#include <algorithm>
#include <limits>

namespace pcl::acmap {

namespace {

/** \brief Cosine of 60 degrees: limits the angles between baselines, axes of the
 * cameras and viewing directions. */
constexpr double min_cosine = 0.5;

/** \brief Mean of one axis over all cameras, in the frame of the reference. */
Eigen::Vector3d
meanAxis(const RigCalibration& calibration, int axis)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const CameraCalibration& camera : calibration.cameras)
    if (camera.is_there)
      sum += camera.T_reference_camera.linear().col(axis);
  return sum.normalized();
}

/** \brief The direction of a baseline, with the sign of the given axis of the cameras.
 */
Eigen::Vector3d
along(const CameraCalibration& neighbour, const Eigen::Vector3d& axis, const char* name)
{
  const Eigen::Vector3d baseline = neighbour.T_reference_camera.translation();
  if (!(baseline.norm() > 1e-6))
    throw acmap::BadArgument(std::string("the ") + name +
                             " camera stands in the reference camera's place");
  const Eigen::Vector3d direction = baseline.normalized();
  const double cosine = direction.dot(axis);
  if (!(std::abs(cosine) > min_cosine))
    throw acmap::BadArgument(
        std::string("the ") + name +
        " camera does not stand beside the reference in the direction of its name: the "
        "baseline is more than 60 degrees off");
  return cosine < 0.0 ? Eigen::Vector3d(-direction) : direction;
}

Eigen::Matrix3d
commonRotation(const RigCalibration& calibration)
{
  const CameraCalibration& horizontal = calibration.camera(RigCamera::Horizontal);
  const CameraCalibration& vertical = calibration.camera(RigCamera::Vertical);
  Eigen::Vector3d x = meanAxis(calibration, 0);
  Eigen::Vector3d y = meanAxis(calibration, 1);
  const Eigen::Vector3d forward = meanAxis(calibration, 2);
  // With one neighbour, the third direction is the viewing direction of the cameras.
  if (horizontal.is_there)
    x = along(horizontal, x, "horizontal");
  if (vertical.is_there)
    y = along(vertical, y, "vertical");
  else
    y = forward.cross(x);
  if (!horizontal.is_there)
    x = y.cross(forward);
  const Eigen::Vector3d across = x.cross(y);
  if (!(std::abs(x.normalized().dot(y.normalized())) < min_cosine))
    throw acmap::BadArgument("the two baselines are less than 60 degrees apart");
  const Eigen::Vector3d z = across.normalized();
  if (!(z.dot(forward) > min_cosine))
    throw acmap::BadArgument("the cameras do not look across their baselines");
  // A single pair keeps its own baseline exactly.
  if (!horizontal.is_there)
    x = y.cross(z).normalized();
  Eigen::Matrix3d rotation;
  rotation.row(0) = x.normalized();
  rotation.row(1) = z.cross(x.normalized());
  rotation.row(2) = z;
  return rotation;
}

/** \brief The region that all cameras see, on the plane z = 1 of the common frame. */
struct CommonBounds {
  Eigen::Vector2d minimum = Eigen::Vector2d::Constant(-1e9);
  Eigen::Vector2d maximum = Eigen::Vector2d::Constant(1e9);
};

Eigen::Vector2d
seenAt(const CameraCalibration& camera,
       const Eigen::Matrix3d& R_common_camera,
       double column,
       double row)
{
  const Eigen::Vector3d ray = R_common_camera * pixelRay(camera, {column, row});
  if (!(ray.z() > 0.05))
    throw acmap::BadArgument("the edge of an image has no ray: the distortion has no "
                             "inverse there, or the camera is turned too far");
  return ray.hnormalized();
}

/** \brief Reduces the region to what a camera sees, along the border of its image. */
void
narrow(const RigCalibration& calibration,
       const CameraCalibration& camera,
       const Eigen::Matrix3d& R_common_camera,
       CommonBounds& window)
{
  const double right = calibration.width - 1;
  const double bottom = calibration.height - 1;
  const auto at = [&](double column, double row) {
    return seenAt(camera, R_common_camera, column, row);
  };
  for (int row = 0; row < calibration.height; ++row) {
    window.minimum.x() = std::max(window.minimum.x(), at(0, row).x());
    window.maximum.x() = std::min(window.maximum.x(), at(right, row).x());
  }
  for (int column = 0; column < calibration.width; ++column) {
    window.minimum.y() = std::max(window.minimum.y(), at(column, 0).y());
    window.maximum.y() = std::min(window.maximum.y(), at(column, bottom).y());
  }
}

/** \brief Sets the smallest focal length for which the window fills the image. */
void
setPinhole(const CommonBounds& window, TrinocularRig& rig)
{
  const Eigen::Vector2d extent = window.maximum - window.minimum;
  const Eigen::Vector2d pixels(rig.width - 1, rig.height - 1);
  if (!(extent.minCoeff() > 0.01))
    throw acmap::BadArgument("the cameras' views have no common part");
  rig.focal_length = pixels.cwiseQuotient(extent).maxCoeff();
  const Eigen::Vector2d middle = 0.5 * (window.minimum + window.maximum);
  rig.center_x = 0.5 * pixels.x() - rig.focal_length * middle.x();
  rig.center_y = 0.5 * pixels.y() - rig.focal_length * middle.y();
}

} // namespace

CommonView
commonViewOf(const RigCalibration& calibration)
{
  const CameraCalibration& horizontal = calibration.camera(RigCamera::Horizontal);
  const CameraCalibration& vertical = calibration.camera(RigCamera::Vertical);
  if (!calibration.camera(RigCamera::Reference).is_there ||
      !(horizontal.is_there || vertical.is_there))
    throw acmap::BadArgument(
        "a rig needs its reference camera and at least one neighbour");
  requireSoundCalibration(calibration);
  requireInRange("width", calibration.width, 2, 32768, "px");
  requireInRange("height", calibration.height, 2, 32768, "px");

  CommonView view;
  view.R_common_reference = commonRotation(calibration);
  view.rig.width = calibration.width;
  view.rig.height = calibration.height;
  const auto offset = [&](const CameraCalibration& camera) -> Eigen::Vector3d {
    return view.R_common_reference * camera.T_reference_camera.translation();
  };
  view.rig.baseline_horizontal = horizontal.is_there ? offset(horizontal).x() : 0.0;
  view.rig.baseline_vertical = vertical.is_there ? offset(vertical).y() : 0.0;
  view.column_offset = vertical.is_there ? offset(vertical).x() : 0.0;
  CommonBounds window;
  for (const CameraCalibration& camera : calibration.cameras)
    if (camera.is_there)
      narrow(calibration, camera, view.rotationOf(camera), window);
  setPinhole(window, view.rig);
  requireSoundRig(view.rig);
  return view;
}

} // namespace pcl::acmap
