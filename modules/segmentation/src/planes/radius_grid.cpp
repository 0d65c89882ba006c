#include "planes/radius_grid.h"

#include <cmath>
#include <tuple>

namespace pcl::acmap::planes {

RadiusGrid::RadiusGrid(const LargeVector<Eigen::Vector3d>& points, double radius)
: points_(points)
, radius_(radius)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      members_.push_back({cubeOf(points[i]), static_cast<std::int32_t>(i)});
  std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
    return std::tie(a.cube.x, a.cube.y, a.cube.z, a.point) <
           std::tie(b.cube.x, b.cube.y, b.cube.z, b.point);
  });
}

bool
RadiusGrid::isBefore(const Member& member, const Cube& cube)
{
  return std::tie(member.cube.x, member.cube.y, member.cube.z) <
         std::tie(cube.x, cube.y, cube.z);
}

RadiusGrid::Cube
RadiusGrid::cubeOf(const Eigen::Vector3d& place) const
{
  // Far away all cubes are one: this costs time, but no points are lost.
  const auto along = [&](double coordinate) {
    return static_cast<std::int64_t>(std::clamp(coordinate / radius_, -1e15, 1e15) -
                                     (coordinate < 0 ? 1 : 0));
  };
  return {along(place.x()), along(place.y()), along(place.z())};
}

} // namespace pcl::acmap::planes
