#include "cylinder_scenes.h"

#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::acmap::test {
namespace {

constexpr int columns = 300, rows = 220;
constexpr double infinity = std::numeric_limits<double>::infinity();

/** The nearest surface along a ray. */
struct RayHit {
  double range = infinity;
  std::int32_t cylinder = -1;
};

/** \param[in] plane a point p is before it if plane . (p, 1) > 0 */
void
meetPlane(const Eigen::Vector3d& ray, const Eigen::Vector4d& plane, RayHit& hit)
{
  const double range = -plane[3] / plane.head<3>().dot(ray);
  if (range > 0 && range < hit.range)
    hit = {range, -1};
}

void
meetCylinder(const Eigen::Vector3d& ray,
             const SceneCylinder& cylinder,
             std::int32_t number,
             RayHit& hit)
{
  const Eigen::Vector3d way = ray - ray.dot(cylinder.axis) * cylinder.axis;
  const Eigen::Vector3d from =
      -cylinder.point + cylinder.point.dot(cylinder.axis) * cylinder.axis;
  const double a = way.squaredNorm(), b = way.dot(from);
  const double rest =
      b * b - a * (from.squaredNorm() - cylinder.radius * cylinder.radius);
  if (rest <= 0)
    return;
  const double range = (-b - std::sqrt(rest)) / a;
  if (range > 0 && range < hit.range)
    hit = {range, number};
}

/** Casts all rays of a camera.
 * \param[in] focal length, pixels
 * \param[in] meet (ray) returns the nearest surface */
template <typename Meet>
void
cast(double focal,
     double sigma,
     std::uint64_t seed,
     const Meet& meet,
     CylinderView& view)
{
  Random random(seed);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector3d ray = Eigen::Vector3d((column - columns / 2 + 0.5) / focal,
                                                  (row - rows / 2 + 0.5) / focal,
                                                  1)
                                      .normalized();
      const RayHit hit = meet(ray);
      if (hit.range == infinity)
        continue;
      const Eigen::Vector3f place =
          ((hit.range + sigma * random.normal()) * ray).cast<float>();
      view.cloud->emplace_back(place.x(), place.y(), place.z());
      view.truth.push_back(hit.cylinder);
    }
}

constexpr double room_focal = 250;

RayHit
meetRoom(const Eigen::Vector3d& ray)
{
  RayHit hit;
  for (const Eigen::Vector4d& plane : planesOfRoom())
    meetPlane(ray, plane, hit);
  return hit;
}

} // namespace

std::vector<Eigen::Vector4d>
planesOfRoom()
{
  return {{0, 0, -1, 5}, {1, 0, 0, 2.5}, {0, -1, 0, 1.4}};
}

CylinderView
seeColumns(double sigma, std::uint64_t seed, std::vector<double> radii)
{
  Random random(1000 + seed);
  for (std::size_t i = radii.size() - 1; i > 0; --i)
    std::swap(radii[i], radii[random.bits() % (i + 1)]);
  CylinderView view;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double z = random.uniform(2.0, 3.6);
    const double x =
        (0.42 * (static_cast<double>(i) - 1) + random.uniform(-0.05, 0.05)) * z;
    const Eigen::Vector3d axis(random.uniform(-0.2, 0.2), 1, random.uniform(-0.2, 0.2));
    view.cylinders.push_back({{x, 0, z}, axis.normalized(), radii[i]});
  }
  cast(
      room_focal,
      sigma,
      seed,
      [&](const Eigen::Vector3d& ray) {
        RayHit hit = meetRoom(ray);
        for (std::size_t i = 0; i < view.cylinders.size(); ++i)
          meetCylinder(ray, view.cylinders[i], static_cast<std::int32_t>(i), hit);
        return hit;
      },
      view);
  return view;
}

CylinderView
seeEmptyRoom(double sigma, std::uint64_t seed)
{
  CylinderView view;
  cast(room_focal, sigma, seed, meetRoom, view);
  return view;
}

CylinderView
seeWall(const std::function<double(double)>& depth, double sigma, std::uint64_t seed)
{
  constexpr double focal = 200, distance = 4, half_width = 3, floor = 1.2;
  CylinderView view;
  cast(
      focal,
      sigma,
      seed,
      [&](const Eigen::Vector3d& ray) {
        RayHit hit;
        double range = distance / ray.z();
        constexpr int steps = 60; // converges, because rays are steeper than the wall
        for (int i = 0; i < steps; ++i)
          range = (distance + depth(range * ray.x())) / ray.z();
        if (std::abs(range * ray.x()) < half_width)
          hit.range = range;
        meetPlane(ray, {0, -1, 0, floor}, hit);
        return hit;
      },
      view);
  return view;
}

CylinderView
seeRoundWall(bool is_hollow, double sigma, std::uint64_t seed)
{
  constexpr double radius = 10, distance = 4;
  const double sign = is_hollow ? -1 : 1;
  CylinderView view = seeWall(
      [&](double x) {
        return sign * (radius - std::sqrt(radius * radius - std::min(x * x, 50.0)));
      },
      sigma,
      seed);
  view.cylinders.push_back({{0, 0, distance + sign * radius}, {0, 1, 0}, radius});
  return view;
}

} // namespace pcl::acmap::test
