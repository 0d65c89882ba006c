#pragma once

#include <pcl/core/impl/planar_geometry.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::acmap {

inline double
distanceToSegment(const Eigen::Vector2d& from,
                  const Eigen::Vector2d& to,
                  const Eigen::Vector2d& place)
{
  return std::sqrt(squaredDistance(place, from, to));
}

inline double
distanceToLoop(const std::vector<Eigen::Vector2d>& loop, const Eigen::Vector2d& place)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < loop.size(); ++k)
    nearest = std::min(nearest,
                       distanceToSegment(loop[k], loop[(k + 1) % loop.size()], place));
  return nearest;
}

} // namespace pcl::acmap
