#include <pcl/core/exceptions.h>
#include <pcl/core/plane_distance.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace pcl {

namespace {

using Eigen::Vector3d;

const std::vector<std::int32_t>&
observationsOf(const CompactMap& map, std::size_t plane)
{
  static const std::vector<std::int32_t> none;
  return map.observations.empty() ? none : map.observations[plane];
}

/** \brief Mean position of the observations of a plane, relative to that of all. */
Vector3d
placeOfObservations(const CompactMap& map,
                    const std::vector<std::int32_t>& observations)
{
  Vector3d all = Vector3d::Zero(), those = Vector3d::Zero();
  for (const Eigen::Isometry3d& pose : map.trajectory.poses)
    all += pose.translation();
  for (const std::int32_t one : observations)
    those += map.trajectory.poses[static_cast<std::size_t>(one)].translation();
  return those / static_cast<double>(observations.size()) -
         all / static_cast<double>(map.trajectory.poses.size());
}

/** \brief Is it known what the poses add to the errors of a plane? */
bool
knowsPoses(const CompactMap& map, std::size_t plane)
{
  return std::isfinite(map.accuracy.pose + map.accuracy.drift) &&
         !map.trajectory.poses.empty() && !observationsOf(map, plane).empty();
}

/** \brief Covariance between the offsets of two planes by their poses. */
double
poseCovariance(const CompactMap& map, std::size_t first, std::size_t second)
{
  if (!knowsPoses(map, first) || !knowsPoses(map, second))
    return 0;
  const std::vector<std::int32_t>& a = observationsOf(map, first);
  const std::vector<std::int32_t>& b = observationsOf(map, second);
  std::vector<std::int32_t> both;
  std::set_intersection(
      a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  const auto count = [](const auto& list) { return static_cast<double>(list.size()); };
  const auto squared = [](double value) { return value * value; };
  return squared(map.accuracy.pose) * count(both) / (count(a) * count(b)) +
         squared(map.accuracy.drift) *
             placeOfObservations(map, a).dot(placeOfObservations(map, b));
}

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

/** \brief Variance of a plane along its normal at a place. */
double
varianceAt(const PlanePatch& plane, const Vector3d& place)
{
  const Vector3d arm = place - plane.center;
  const Vector3d gains(arm.dot(plane.axis_u), arm.dot(plane.axis_v), 1);
  return gains.dot(plane.covariance * gains);
}

} // namespace

double
acmap::poseVariance(const CompactMap& map, std::size_t plane)
{
  return poseCovariance(map, plane, plane);
}

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
  const Vector3d along =
      (normal + (normal.dot(other) > 0 ? 1 : -1) * other).normalized();
  const double from_b =
      -b.coefficients.dot(result.place.homogeneous()) / along.dot(other);
  result.distance = std::abs(from_b);
  const double scale = std::isfinite(map.accuracy.scale) ? map.accuracy.scale : 0;
  const double variance =
      varianceAt(a, result.place) + varianceAt(b, result.place + from_b * along) -
      2 * poseCovariance(map, first, second) + std::pow(scale * result.distance, 2);
  result.deviation = std::sqrt(std::max(variance, 0.0));
  if (std::isnan(variance))
    result.deviation = variance;
  result.is_at_least = !knowsPoses(map, first) || !knowsPoses(map, second);
  return result;
}

} // namespace pcl
