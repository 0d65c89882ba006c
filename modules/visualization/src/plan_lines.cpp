#include "plan_lines.h"

#include <pcl/core/cylinder_facets.h>
#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

using Eigen::Vector3d;

constexpr double way_pixels = 3;
constexpr double wall_pixels = 3;
constexpr double low_wall_pixels = 1;
constexpr Color wall_color = {0.12, 0.12, 0.14};
constexpr Color low_wall_color = {0.62, 0.62, 0.64};

/** Component of a normal along up, above which a plane is no wall. */
constexpr double steep = 0.3;

double
slopeOf(const PlanePatch& plane, const Vector3d& up)
{
  return plane.coefficients.head<3>().dot(up);
}

/** \brief Moves lines vertically to a level; their plan does not change. */
void
lift(std::vector<MapLine>& lines, const Vector3d& up, double level)
{
  for (MapLine& line : lines)
    for (Eigen::Vector3f& point : line.points)
      point += ((level - point.cast<double>().dot(up)) * up).cast<float>();
}

} // namespace

std::optional<double>
eyeLevel(const Trajectory& trajectory, const Vector3d& up)
{
  std::vector<double> levels;
  for (const Eigen::Vector3f& eye : lineOf(trajectory).points)
    levels.push_back(eye.cast<double>().dot(up));
  if (levels.empty())
    return {};
  return medianOf(levels);
}

bool
looksDown(const PlanePatch& plane, const Vector3d& up)
{
  return slopeOf(plane, up) < -steep;
}

bool
looksDown(const CylinderPatch& cylinder, const Vector3d& up)
{
  const double side = cylinder.is_hollow ? -1 : 1;
  return cylinder.arc <= M_PI && side * cylinder.axis_u.dot(up) < -steep;
}

Actors
actorsOfPlan(const CompactMap& map,
             const Vector3d& up,
             const std::vector<Eigen::Vector3f>& samples)
{
  double low = INFINITY, high = -INFINITY;
  for (const Eigen::Vector3f& sample : samples) {
    low = std::min(low, sample.cast<double>().dot(up));
    high = std::max(high, sample.cast<double>().dot(up));
  }
  std::vector<MapLine> cut, other, way = {lineOf(map.trajectory)};
  // walls are cut at the height of the cameras, or at half height without cameras
  const double level = eyeLevel(map.trajectory, up).value_or((low + high) / 2);
  for (std::size_t plane = 0; plane < map.planes.size(); ++plane)
    if (std::abs(slopeOf(map.planes[plane], up)) <= steep) {
      append(cut, sectionOf(map.planes[plane], plane, up, level));
      append(other, outlinesOf(map, plane));
    }
  for (std::size_t i = 0; i < map.cylinders.size(); ++i)
    for (const PlanePatch& facet : facetsOfCylinder(map.cylinders[i]))
      if (std::abs(slopeOf(facet, up)) <= steep)
        append(cut, sectionOf(facet, map.planes.size() + i, up, level));
  const double step = 0.004 * (high - low);
  lift(other, up, high);
  lift(cut, up, high + step);
  lift(way, up, high + 2 * step);
  return {actorOfLines(other, low_wall_color, low_wall_pixels),
          actorOfLines(cut, wall_color, wall_pixels),
          actorOfLines(way, trajectory_color, way_pixels)};
}

} // namespace pcl::acmap
