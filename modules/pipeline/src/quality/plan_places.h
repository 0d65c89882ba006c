#pragma once

#include <pcl/texture/floor_plan.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::acmap {

/** \brief Is a place within a loop? */
inline bool
isInLoop(const std::vector<Eigen::Vector2d>& loop, const Eigen::Vector2d& place)
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

/** \brief Is a place within an odd number of the loops? */
inline bool
isInLoops(const std::vector<std::vector<Eigen::Vector2d>>& loops,
          const Eigen::Vector2d& place)
{
  bool is_inside = false;
  for (const auto& loop : loops)
    is_inside ^= isInLoop(loop, place);
  return is_inside;
}

inline double
distanceToSegment(const Eigen::Vector2d& from,
                  const Eigen::Vector2d& to,
                  const Eigen::Vector2d& place)
{
  const Eigen::Vector2d way = to - from;
  const double length = way.squaredNorm();
  const double share =
      length > 0 ? std::min(1.0, std::max(0.0, way.dot(place - from) / length)) : 0;
  return (from + share * way - place).norm();
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

/** \brief A point of a plan in the map frame. */
inline Eigen::Vector3d
pointOfPlan(const FloorPlan& plan, const Eigen::Vector2d& place, double height)
{
  return place.x() * plan.x_axis + place.y() * plan.y_axis +
         (plan.floor + height) * plan.up;
}

/** \brief A direction or point of the map, seen from above. */
inline Eigen::Vector2d
flatOf(const FloorPlan& plan, const Eigen::Vector3d& point)
{
  return {point.dot(plan.x_axis), point.dot(plan.y_axis)};
}

} // namespace pcl::acmap
