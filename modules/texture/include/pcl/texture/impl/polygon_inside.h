#pragma once

#include <pcl/core/build_config.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Is a place inside of an odd number of loops? */
inline bool
isInside(const std::vector<std::vector<Eigen::Vector2d>>& loops,
         const Eigen::Vector2d& place)
{
  bool is_inside = false;
  for (const std::vector<Eigen::Vector2d>& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Eigen::Vector2d &a = loop[k], &b = loop[(k + 1) % loop.size()];
      if ((a.y() > place.y()) != (b.y() > place.y()) &&
          place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        is_inside = !is_inside;
    }
  return is_inside;
}

} // namespace pcl::acmap
