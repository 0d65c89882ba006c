#include "wall_direction.h"

#include <cmath>
#include <limits>

namespace pcl::acmap {

double
wallDirection(const PointView& points, const PointView& normals, std::size_t i)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (normals.size() == 0)
    return none;
  const Eigen::Vector3d normal = normals[i].cast<double>();
  if (!normal.allFinite())
    return none;
  const double level = std::hypot(normal[0], normal[2]);
  if (!(level > std::abs(normal[1])))
    return none;
  const double away = normal.dot(points[i].cast<double>());
  const double side = away > 0 ? -1 : 1;
  return std::atan2(side * normal[2], side * normal[0]);
}

} // namespace pcl::acmap
