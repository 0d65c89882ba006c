#include "planes/unreached_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl::acmap::planes {

UnreachedPoints::UnreachedPoints(const LargeVector<Eigen::Vector3d>& points,
                                 double radius)
: points_(points)
, radius_(radius)
, slot_of_(points.size())
, cube_of_(points.size())
{
  std::vector<std::pair<Place, std::int32_t>> placed;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      placed.emplace_back(placeOf(points[i]), static_cast<std::int32_t>(i));
  std::sort(placed.begin(), placed.end());
  order_.reserve(placed.size());
  for (const auto& [place, point] : placed) {
    const auto slot = static_cast<std::uint32_t>(order_.size());
    if (cubes_.empty() || cubes_.back().place != place)
      cubes_.push_back({place, slot, slot, slot});
    cubes_.back().end = cubes_.back().unreached = slot + 1;
    order_.push_back(point);
    slot_of_[static_cast<std::size_t>(point)] = slot;
    cube_of_[static_cast<std::size_t>(point)] =
        static_cast<std::uint32_t>(cubes_.size() - 1);
  }
  around_.resize(cubes_.size());
}

void
UnreachedPoints::reach(std::int32_t i)
{
  const std::uint32_t cube = cube_of_[static_cast<std::size_t>(i)];
  pass(cube, slot_of_[static_cast<std::size_t>(i)]);
}

void
UnreachedPoints::restore()
{
  for (const std::uint32_t cube : touched_) {
    cubes_[cube].unreached = cubes_[cube].end;
    cubes_[cube].is_touched = false;
  }
  for (const std::uint32_t cube : asked_) {
    std::vector<std::uint32_t>().swap(around_[cube]);
    cubes_[cube].is_asked = false;
  }
  touched_.clear();
  asked_.clear();
}

void
UnreachedPoints::remove(std::int32_t i)
{
  Cube& cube = cubes_[cube_of_[static_cast<std::size_t>(i)]];
  swap(slot_of_[static_cast<std::size_t>(i)], --cube.end);
  cube.unreached = cube.end;
}

UnreachedPoints::Place
UnreachedPoints::placeOf(const Eigen::Vector3d& point) const
{
  // Far away all cubes are one: this costs time, but no points are lost.
  constexpr double farthest = 1e15;
  Place place;
  for (int axis = 0; axis < 3; ++axis)
    place[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(
        std::clamp(static_cast<double>(cubes_of_radius) / radius_ * point[axis],
                   -farthest,
                   farthest)));
  return place;
}

std::vector<std::uint32_t>&
UnreachedPoints::cubesAround(std::int32_t i)
{
  const std::uint32_t middle = cube_of_[static_cast<std::size_t>(i)];
  std::vector<std::uint32_t>& around = around_[middle];
  if (cubes_[middle].is_asked)
    return around;
  cubes_[middle].is_asked = true;
  asked_.push_back(middle);
  const Place& place = cubes_[middle].place;
  constexpr std::int64_t reach = cubes_of_radius;
  for (std::int64_t x = place[0] - reach; x <= place[0] + reach; ++x)
    for (std::int64_t y = place[1] - reach; y <= place[1] + reach; ++y) {
      auto cube =
          std::lower_bound(cubes_.begin(),
                           cubes_.end(),
                           Place{x, y, place[2] - reach},
                           [](const Cube& a, const Place& b) { return a.place < b; });
      for (; cube != cubes_.end() && cube->place[0] == x && cube->place[1] == y &&
             cube->place[2] <= place[2] + reach;
           ++cube)
        around.push_back(static_cast<std::uint32_t>(cube - cubes_.begin()));
    }
  return around;
}

void
UnreachedPoints::pass(std::uint32_t cube, std::uint32_t slot)
{
  swap(slot, --cubes_[cube].unreached);
  if (cubes_[cube].is_touched)
    return;
  cubes_[cube].is_touched = true;
  touched_.push_back(cube);
}

void
UnreachedPoints::swap(std::uint32_t a, std::uint32_t b)
{
  std::swap(order_[a], order_[b]);
  slot_of_[static_cast<std::size_t>(order_[a])] = a;
  slot_of_[static_cast<std::size_t>(order_[b])] = b;
}

} // namespace pcl::acmap::planes
