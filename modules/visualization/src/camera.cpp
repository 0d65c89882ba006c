#include "camera.h"

#include "camera_fit.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::acmap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double view_angle = 36.0; // degrees
constexpr int max_pixels = 16384;

/** Rotation of the view from the direction of the sensor, or from a horizontal
 * direction. */
constexpr double sensor_yaw = 18.0 * degree;
constexpr double sensor_pitch = 10.0 * degree;
constexpr double object_yaw = 35.0 * degree;
constexpr double object_pitch = 30.0 * degree;

/** \brief Are nearly all points in the field of view of a camera? */
bool
isSeenFrom(const Eigen::Vector3f& origin,
           const Eigen::Quaternionf& orientation,
           const std::vector<Eigen::Vector3f>& points)
{
  constexpr float widest_slope = 1.5F;
  const Eigen::Quaternionf to_sensor = orientation.conjugate();
  const auto seen = std::count_if(points.begin(), points.end(), [&](const auto& p) {
    const Eigen::Vector3f q = to_sensor * (p - origin);
    return q.z() > 0 &&
           std::max(std::abs(q.x()), std::abs(q.y())) <= widest_slope * q.z();
  });
  return static_cast<double>(seen) >= 0.95 * static_cast<double>(points.size());
}

/** \brief Orientation of the sensor that observed the points, if there is one. */
std::optional<Eigen::Quaternionf>
seeingSensor(const SceneView& view, const std::vector<Eigen::Vector3f>& points)
{
  // grabbers may write points in the camera frame together with a meaningless
  // orientation
  if (!view.sensor_origin)
    return {};
  for (const auto& orientation :
       {view.sensor_orientation, Eigen::Quaternionf(Eigen::Quaternionf::Identity())})
    if (isSeenFrom(*view.sensor_origin, orientation, points))
      return orientation;
  return {};
}

Vector3d
upOf(const SceneView& view,
     const std::optional<Eigen::Quaternionf>& sensor,
     const RobustBox& box)
{
  if (view.up)
    return view.up->cast<double>().normalized();
  if (sensor)
    return (*sensor * -Eigen::Vector3f::UnitY()).cast<double>();
  return box.half.y() < box.half.z() ? Vector3d(-Vector3d::UnitY()) : Vector3d::UnitZ();
}

/** \brief Is the sensor on one side of nearly all points? */
bool
isBeside(const Eigen::Vector3f& sensor,
         const Eigen::Vector3f& middle,
         const std::vector<Eigen::Vector3f>& points)
{
  constexpr float least_cosine = 0.35F; // with the direction of the middle
  const Eigen::Vector3f ahead = (middle - sensor).normalized();
  const auto seen = std::count_if(points.begin(), points.end(), [&](const auto& p) {
    return (p - sensor).dot(ahead) > least_cosine * (p - sensor).norm();
  });
  return static_cast<double>(seen) >= 0.95 * static_cast<double>(points.size());
}

/** \brief The horizontal direction across the longer side of points, away from the
 * origin, where scanners often stand. */
Vector3d
acrossOf(const std::vector<Eigen::Vector3f>& points,
         const RobustBox& box,
         const Vector3d& up)
{
  constexpr double stray_factor = 3;
  const Vector3d e = up.unitOrthogonal(), f = up.cross(e);
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3f& point : points)
    if (const Vector3d p = point.cast<double>(); box.contains(p, stray_factor)) {
      const Eigen::Vector2d q((p - box.middle).dot(e), (p - box.middle).dot(f));
      spread += q * q.transpose();
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(spread);
  const Eigen::Vector2d least = solver.eigenvectors().col(0);
  const Vector3d across = least.x() * e + least.y() * f;
  return across.dot(box.middle) < 0 ? Vector3d(-across) : across;
}

/** \brief Default viewing direction.
 * \param[in] facing mean normal of the surface; zero if there is none */
Vector3d
obliqueDirection(const SceneView& view,
                 const std::vector<Eigen::Vector3f>& points,
                 const RobustBox& box,
                 const Vector3d& facing,
                 const Vector3d& up)
{
  if (view.sensor_origin &&
      isBeside(*view.sensor_origin, box.middle.cast<float>(), points)) {
    const Vector3d focus = view.look ? Vector3d(view.look->cast<double>()) : box.middle;
    const Vector3d straight = focus - view.sensor_origin->cast<double>();
    return turned(straight.normalized(), up, sensor_yaw, sensor_pitch);
  }
  constexpr double one_sided = 0.6, turned_away = 0.1; // share of the area
  const Vector3d level = -(facing - facing.dot(up) * up);
  if (level.norm() > one_sided)
    return turned(level.normalized(), up, sensor_yaw, sensor_pitch);
  return turned(level.norm() > turned_away ? Vector3d(level.normalized())
                                           : acrossOf(points, box, up),
                up,
                object_yaw,
                object_pitch);
}

/** \brief Up direction orthogonal to the viewing direction. */
Vector3d
uprightUp(const Vector3d& up, const Vector3d& direction)
{
  const Vector3d upright = up - up.dot(direction) * direction;
  return upright.norm() > 1e-3 ? Vector3d(upright.normalized())
                               : direction.unitOrthogonal();
}

} // namespace

Vector3d
turned(const Vector3d& direction, const Vector3d& up, double yaw, double pitch)
{
  const Vector3d level = AngleAxisd(yaw, up) * direction;
  const Vector3d right = level.cross(up);
  if (right.norm() < 1e-6)
    return level;
  return AngleAxisd(-pitch, right.normalized()) * level;
}

void
requireSound(const SceneView& view)
{
  requireInRange("width", view.width, 1, max_pixels, "pixels");
  requireInRange("height", view.height, 1, max_pixels, "pixels");
  for (const auto* vector : {&view.from, &view.look, &view.up})
    if (*vector && !(*vector)->allFinite())
      throw acmap::BadArgument("a place or direction of the view is not finite");
  if (view.up && view.up->norm() == 0)
    throw acmap::BadArgument("up of the view is refused: it has no length");
}

Camera
lookAlong(const std::vector<Eigen::Vector3f>& points,
          const Vector3d& direction,
          const Vector3d& up,
          const SceneView& view)
{
  const RobustBox box(points);
  Camera camera;
  camera.vertical = up;
  camera.view_angle = view_angle;
  camera.focus = view.look ? Vector3d(view.look->cast<double>()) : box.middle;
  if (view.from) {
    camera.position = view.from->cast<double>();
    const Vector3d ahead = camera.focus - camera.position;
    if (ahead.norm() == 0)
      throw acmap::BadArgument("the view looks from a point to the same point");
    camera.up = uprightUp(up, ahead.normalized());
  }
  else {
    const double aspect = static_cast<double>(view.width) / view.height;
    camera.up = uprightUp(up, direction);
    fitCamera(camera, direction, points, box, aspect, !view.look);
  }
  setDepths(camera, points, box);
  return camera;
}

Camera
placeCamera(const std::vector<Eigen::Vector3f>& points,
            const Eigen::Vector3d& facing,
            const SceneView& view)
{
  requireSound(view);
  const RobustBox box(points);
  const auto sensor = seeingSensor(view, points);
  const Vector3d up = upOf(view, sensor, box);
  return lookAlong(points, obliqueDirection(view, points, box, facing, up), up, view);
}

} // namespace pcl::acmap
