#include <pcl/core/exceptions.h>
#include <pcl/core/plane_distance.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl {

namespace {

using Eigen::Vector3d;

void
requirePlane(const CompactMap& map, std::size_t plane)
{
  if (plane >= map.planes.size())
    throw acmap::BadArgument("a map of " + std::to_string(map.planes.size()) +
                             " planes has no plane " + std::to_string(plane));
  if (map.planes[plane].polygons.empty() ||
      map.planes[plane].polygons.front().outer.empty())
    throw acmap::BadArgument("plane " + std::to_string(plane) + " has no polygon");
}

/** \brief The rectangle around a plane, along axes. */
Eigen::AlignedBox2d
extentOf(const PlanePatch& plane, const Vector3d& u, const Vector3d& v)
{
  Eigen::AlignedBox2d box;
  for (const PlanePolygon& polygon : plane.polygons)
    for (const Eigen::Vector3f& corner : polygon.outer)
      box.extend(
          Eigen::Vector2d(corner.cast<double>().dot(u), corner.cast<double>().dot(v)));
  return box;
}

/** \brief Where both planes are, along the axes of the first one. */
Eigen::Vector2d
middleOf(const PlanePatch& first, const PlanePatch& second)
{
  const Eigen::AlignedBox2d a = extentOf(first, first.axis_u, first.axis_v);
  const Eigen::AlignedBox2d b = extentOf(second, first.axis_u, first.axis_v);
  const Eigen::AlignedBox2d both = a.intersection(b);
  return both.isEmpty() ? Eigen::Vector2d((a.center() + b.center()) / 2)
                        : both.center();
}

/** \brief How an offset at a place depends on slopes and offset of a plane. */
Vector3d
gainsAt(const PlanePatch& plane, const Vector3d& place)
{
  const Vector3d arm = place - plane.center;
  return {arm.dot(plane.axis_u), arm.dot(plane.axis_v), 1};
}

/** \brief Variance between two planes at places.
 * \param[in] sign that of the second normal with respect to the first one */
double
varianceBetween(const PlanePatch& first,
                const Vector3d& first_place,
                const PlanePatch& second,
                const Vector3d& second_place,
                double sign)
{
  const Vector3d a = gainsAt(first, first_place), b = gainsAt(second, second_place);
  double variance = a.dot(first.covariance * a) + b.dot(second.covariance * b);
  const std::size_t modes = std::min(first.pose_modes.size(), second.pose_modes.size());
  for (std::size_t k = 0; k < modes; ++k)
    variance -= 2 * sign * a.dot(first.pose_modes[k]) * b.dot(second.pose_modes[k]);
  return variance;
}

} // namespace

PlaneDistance
distanceBetween(const CompactMap& map, std::size_t first, std::size_t second)
{
  requirePlane(map, first);
  requirePlane(map, second);
  const PlanePatch &a = map.planes[first], &b = map.planes[second];
  const Vector3d normal = a.coefficients.head<3>(), other = b.coefficients.head<3>();
  constexpr double max_angle = 5, degrees = 180 / M_PI;
  const double angle = degrees * std::acos(std::min(1.0, std::abs(normal.dot(other))));
  if (!(angle <= max_angle))
    throw acmap::BadArgument("planes " + std::to_string(first) + " and " +
                             std::to_string(second) + " are " + std::to_string(angle) +
                             " degrees from parallel: they have no distance");
  const Eigen::Vector2d middle = middleOf(a, b);
  PlaneDistance result;
  const Vector3d flat = middle.x() * a.axis_u + middle.y() * a.axis_v;
  result.place = flat - a.coefficients.dot(flat.homogeneous()) * normal;
  // along the mean of both normals, which is the same in both orders
  const double sign = normal.dot(other) > 0 ? 1 : -1;
  const Vector3d along = (normal + sign * other).normalized();
  const double from_b =
      -b.coefficients.dot(result.place.homogeneous()) / along.dot(other);
  result.distance = std::abs(from_b);
  const double variance =
      varianceBetween(a, result.place, b, result.place + from_b * along, sign);
  result.deviation =
      std::isnan(variance) ? variance : std::sqrt(std::max(variance, 0.0));
  result.is_at_least = a.pose_modes.empty() || b.pose_modes.empty();
  return result;
}

} // namespace pcl
