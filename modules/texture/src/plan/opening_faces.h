#pragma once

#include <pcl/texture/floor_plan.h>

namespace pcl::acmap {

/** \brief Faces of one wall are at most that far apart, metres. */
inline constexpr double thickest_wall = 0.6;

/** \brief The side from which a wall or an opening of a plan is seen, unit length. */
template <typename Segment>
Eigen::Vector2d
frontOf(const Segment& one)
{
  const Eigen::Vector2d along = (one.to - one.from).normalized();
  return {-along.y(), along.x()};
}

/** \brief Are these one opening, seen from both sides of a wall? */
inline bool
areFaces(const PlanOpening& one, const PlanOpening& other)
{
  const Eigen::Vector2d along = (one.to - one.from).normalized();
  const Eigen::Vector2d middle = (other.from + other.to) / 2 - one.from;
  const double behind = -middle.dot(frontOf(one));
  return one.is_window == other.is_window && frontOf(one).dot(frontOf(other)) < 0 &&
         behind >= 0 && behind <= thickest_wall && middle.dot(along) >= 0 &&
         middle.dot(along) <= (one.to - one.from).norm();
}

} // namespace pcl::acmap
