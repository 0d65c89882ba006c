#pragma once

#include <pcl/core/build_config.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief The signed area between two vectors, positive if the second one is on the left of the
 * first. */
inline double
crossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** \brief The squared distance of a point from the segment between two others. */
inline double
squaredDistance(const Eigen::Vector2d& point,
                const Eigen::Vector2d& begin,
                const Eigen::Vector2d& end)
{
  const Eigen::Vector2d way = end - begin;
  const double square = way.squaredNorm();
  const double along =
      square > 0 ? std::clamp((point - begin).dot(way) / square, 0.0, 1.0) : 0.0;
  return (begin + along * way - point).squaredNorm();
}

/** \brief Is a place inside of a loop? */
inline bool
isInside(const std::vector<Eigen::Vector2d>& loop, const Eigen::Vector2d& place)
{
  bool is_inside = false;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Eigen::Vector2d &a = loop[k], &b = loop[(k + 1) % loop.size()];
    if ((a.y() > place.y()) != (b.y() > place.y()) &&
        place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      is_inside = !is_inside;
  }
  return is_inside;
}

/** \brief Is a place inside of an odd number of loops? */
inline bool
isInside(const std::vector<std::vector<Eigen::Vector2d>>& loops,
         const Eigen::Vector2d& place)
{
  bool is_inside = false;
  for (const std::vector<Eigen::Vector2d>& loop : loops)
    is_inside ^= isInside(loop, place);
  return is_inside;
}

} // namespace pcl::acmap
