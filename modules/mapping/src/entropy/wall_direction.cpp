#include "wall_direction.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

double
WallDirection::angle() const
{
  return std::atan2(z, x);
}

int
WallDirection::sector() const
{
  // The octant, then its quarter by the tangents of the inner borders.
  const double wide = std::max(std::abs(x), std::abs(z));
  const double narrow = std::min(std::abs(x), std::abs(z));
  const int quarter = (narrow > 0.19891236737965800 * wide) +
                      (narrow > 0.41421356237309505 * wide) +
                      (narrow > 0.66817863791929891 * wide);
  const int octant = (x < 0) + 2 * (z < 0) + 4 * (std::abs(z) > std::abs(x));
  return 4 * octant + quarter;
}

WallDirection
wallDirection(const PointView& points, const PointView& normals, std::size_t i)
{
  if (normals.size() == 0)
    return {};
  const Eigen::Vector3d normal = normals[i].cast<double>();
  if (!normal.allFinite())
    return {};
  const double level = std::sqrt(normal[0] * normal[0] + normal[2] * normal[2]);
  if (!(level > std::abs(normal[1])))
    return {};
  const double away = normal.dot(points[i].cast<double>());
  const double scale = (away > 0 ? -1 : 1) / level;
  return {scale * normal[0], scale * normal[2]};
}

} // namespace pcl::acmap
