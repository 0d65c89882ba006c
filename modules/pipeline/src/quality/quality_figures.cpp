#include "quality/quality_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace pcl::acmap {

namespace {

using Cell = std::pair<std::int32_t, std::int32_t>;

/** \brief A sighting of fewer points does not count. */
constexpr std::uint32_t min_points = 8;

bool
isMain(const PlanePatch& plane)
{
  const SurfaceRole role = plane.label.role;
  return role == SurfaceRole::Floor || role == SurfaceRole::Ceiling ||
         role == SurfaceRole::Wall;
}

/** \brief The planes by which a map is judged. */
std::vector<std::size_t>
judgedPlanes(const CompactMap& map)
{
  std::vector<std::size_t> main, all;
  for (std::size_t plane = 0; plane < map.planes.size(); ++plane) {
    all.push_back(plane);
    if (isMain(map.planes[plane]))
      main.push_back(plane);
  }
  return main.empty() ? all : main;
}

/** \brief Where a plane was seen, apart from its rim. */
std::set<Cell>
innerCells(const std::vector<PlaneSighting>& sightings)
{
  std::map<Cell, std::uint32_t> points;
  for (const PlaneSighting& one : sightings)
    points[{one.cell.x(), one.cell.y()}] += one.points;
  const auto isSeen = [&](std::int32_t u, std::int32_t v) {
    const auto found = points.find({u, v});
    return found != points.end() && found->second >= min_points;
  };
  std::set<Cell> inner;
  for (const auto& [cell, number] : points) {
    const auto [u, v] = cell;
    if (isSeen(u, v) && isSeen(u - 1, v) && isSeen(u + 1, v) && isSeen(u, v - 1) &&
        isSeen(u, v + 1))
      inner.insert(cell);
  }
  return inner;
}

/** \brief Does a ray pass through a plane, within its inner cells, well before it ends? */
bool
passes(const SampledRay& ray, const PlanePatch& plane, const std::set<Cell>& cells)
{
  const double margin = std::max(0.1, 4 * plane.rms); // metres
  const Eigen::Vector3d sensor = ray.sensor.cast<double>(),
                        point = ray.point.cast<double>();
  const double before = plane.coefficients.dot(sensor.homogeneous()),
               after = plane.coefficients.dot(point.homogeneous());
  if (!(before * after < 0) || std::abs(before) < margin || std::abs(after) < margin)
    return false;
  const Eigen::Vector3d arm =
      sensor + before / (before - after) * (point - sensor) - plane.center;
  const auto cellOf = [&](const Eigen::Vector3d& axis) {
    return static_cast<std::int32_t>(
        std::floor(arm.dot(axis) / PlaneSightings::cell_size));
  };
  return cells.count({cellOf(plane.axis_u), cellOf(plane.axis_v)}) > 0;
}

/** \brief The observations of each cell of the planes, and the cells of each observation. */
struct SharedCells {
  explicit SharedCells(const PlaneSightings& sightings)
  : of_view(sightings.observations)
  , points(sightings.observations)
  {
    for (const std::vector<PlaneSighting>& plane : sightings.planes)
      for (std::size_t k = 0; k < plane.size(); ++k) {
        if (k == 0 || plane[k - 1].cell != plane[k].cell)
          members.emplace_back();
        const auto view = static_cast<std::size_t>(plane[k].view);
        if (view >= points.size())
          continue;
        members.back().emplace_back(view, plane[k].points);
        of_view[view].push_back(members.size() - 1);
        points[view] += plane[k].points;
      }
  }

  std::vector<std::vector<std::pair<std::size_t, double>>>
      members; ///< and their points
  std::vector<std::vector<std::size_t>> of_view;
  std::vector<double> points; ///< of each observation, on planes
};

} // namespace

std::vector<double>
roughnessOf(const PlaneSightings& sightings)
{
  constexpr double max_weight = 50;
  std::vector<double> roughness;
  for (const std::vector<PlaneSighting>& plane : sightings.planes) {
    double sum = 0, weights = 0;
    for (const PlaneSighting& one : plane) {
      if (one.points < min_points)
        continue;
      const double weight = std::min<double>(one.points, max_weight);
      sum += weight * (one.offset * one.offset - one.spread * one.spread / one.points);
      weights += weight;
    }
    roughness.push_back(weights > 0 ? std::sqrt(std::max(0.0, sum / weights))
                                    : std::numeric_limits<double>::quiet_NaN());
  }
  return roughness;
}

double
unevennessOf(const CompactMap& map, const std::vector<double>& roughness)
{
  double sum = 0, area = 0;
  for (const std::size_t plane : judgedPlanes(map))
    if (plane < roughness.size() && std::isfinite(roughness[plane])) {
      sum += map.planes[plane].area * roughness[plane] * roughness[plane];
      area += map.planes[plane].area;
    }
  return area > 0 ? std::sqrt(sum / area) : std::numeric_limits<double>::quiet_NaN();
}

double
disagreementOf(const CompactMap& map, const PlaneSightings& sightings)
{
  double sum = 0, weights = 0;
  for (const std::size_t plane : judgedPlanes(map)) {
    if (plane >= sightings.planes.size())
      continue;
    const std::vector<PlaneSighting>& all = sightings.planes[plane];
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
      std::vector<double> offsets;
      double noise = 0;
      for (end = begin; end < all.size() && all[end].cell == all[begin].cell; ++end)
        if (all[end].points >= min_points) {
          offsets.push_back(all[end].offset);
          noise += all[end].spread * all[end].spread / all[end].points;
        }
      if (offsets.size() < 2)
        continue;
      const auto number = static_cast<double>(offsets.size());
      double mean = 0, squares = 0;
      for (const double offset : offsets)
        mean += offset / number;
      for (const double offset : offsets)
        squares += (offset - mean) * (offset - mean);
      sum += squares - (number - 1) / number * noise;
      weights += number - 1;
    }
  }
  return weights > 0 ? std::sqrt(std::max(0.0, sum / weights))
                     : std::numeric_limits<double>::quiet_NaN();
}

double
rayAgreement(const CompactMap& map, const PlaneSightings& sightings)
{
  if (sightings.rays.empty())
    return std::numeric_limits<double>::quiet_NaN();
  constexpr double min_area = 0.3; // square metres
  std::vector<std::pair<std::size_t, std::set<Cell>>> faces;
  for (std::size_t plane = 0;
       plane < std::min(map.planes.size(), sightings.planes.size());
       ++plane)
    if (map.planes[plane].area >= min_area)
      if (std::set<Cell> cells = innerCells(sightings.planes[plane]); !cells.empty())
        faces.emplace_back(plane, std::move(cells));
  std::size_t through = 0;
  for (const SampledRay& ray : sightings.rays)
    through += std::any_of(faces.begin(), faces.end(), [&](const auto& face) {
      return static_cast<std::int32_t>(face.first) != ray.plane &&
             passes(ray, map.planes[face.first], face.second);
    });
  return 1 - static_cast<double>(through) / static_cast<double>(sightings.rays.size());
}

WeakestOverlap
weakestOverlap(const PlaneSightings& sightings)
{
  WeakestOverlap weakest;
  const std::size_t views = sightings.observations;
  if (views < 2)
    return weakest;
  const SharedCells cells(sightings);
  std::vector<double> shared(views); // points in cells that joined ones saw
  std::vector<char> is_joined(views, 0), is_cell_joined(cells.members.size(), 0);
  const auto join = [&](std::size_t view) {
    is_joined[view] = 1;
    for (const std::size_t cell : cells.of_view[view])
      if (!std::exchange(is_cell_joined[cell], 1))
        for (const auto& [other, points] : cells.members[cell])
          shared[other] += points;
  };
  const auto shareOf = [&](std::size_t view) {
    return shared[view] / cells.points[view];
  };
  const auto first = std::find_if(cells.points.begin(),
                                  cells.points.end(),
                                  [](double points) { return points > 0; });
  if (first == cells.points.end())
    return weakest;
  join(static_cast<std::size_t>(first - cells.points.begin()));
  for (;;) {
    std::optional<std::size_t> next;
    for (std::size_t view = 0; view < views; ++view)
      if (!is_joined[view] && cells.points[view] > 0 &&
          (!next || shareOf(view) > shareOf(*next)))
        next = view;
    if (!next)
      return weakest;
    if (!(shareOf(*next) >= weakest.share))
      weakest = {shareOf(*next), *next};
    join(*next);
  }
}

} // namespace pcl::acmap
