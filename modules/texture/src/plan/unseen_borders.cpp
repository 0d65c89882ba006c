#include "plan/unseen_borders.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;
using Loop = std::vector<Vector2d>;

constexpr double near = 0.25; // metres, from the border of a room to its wall

double
distanceTo(const Vector2d& from, const Vector2d& to, const Vector2d& place)
{
  const Vector2d way = to - from;
  const double share =
      way.squaredNorm() > 0 ? way.dot(place - from) / way.squaredNorm() : 0;
  return (from + std::clamp(share, 0.0, 1.0) * way - place).norm();
}

bool
isBeside(const FloorPlan& plan, const Vector2d& place)
{
  const auto isNear = [&](const auto& one) {
    return distanceTo(one.from, one.to, place) < near;
  };
  return std::any_of(plan.walls.begin(), plan.walls.end(), isNear) ||
         std::any_of(plan.openings.begin(), plan.openings.end(), isNear) ||
         std::any_of(plan.unseen_walls.begin(), plan.unseen_walls.end(), isNear) ||
         std::any_of(plan.columns.begin(), plan.columns.end(), [&](const auto& column) {
           return std::abs((place - column.center).norm() - column.radius) < near;
         });
}

/** \brief Points along a closed line, with its corners.
 * \param[in] step metres */
Loop
dividedLine(const Loop& outline, double step)
{
  Loop points;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector2d &a = outline[k], &b = outline[(k + 1) % outline.size()];
    const auto steps = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
    for (int s = 0; s < steps; ++s)
      points.push_back(a + static_cast<double>(s) / steps * (b - a));
  }
  return points;
}

void
addOpenBorders(const FloorPlan& plan, const Loop& outline, std::vector<Loop>& borders)
{
  constexpr double shortest = 0.3, step = 0.1; // metres
  constexpr double most_steps = 4000;
  double length = 0;
  for (std::size_t k = 0; k < outline.size(); ++k)
    length += (outline[(k + 1) % outline.size()] - outline[k]).norm();
  Loop border;
  const auto finish = [&] {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < border.size(); ++k)
      sum += (border[k + 1] - border[k]).norm();
    if (sum >= shortest)
      borders.push_back(border);
    border.clear();
  };
  for (const Vector2d& place : dividedLine(outline, std::max(step, length / most_steps)))
    if (isBeside(plan, place))
      finish();
    else
      border.push_back(place);
  finish();
}

} // namespace

std::vector<Loop>
unseenBordersOf(const FloorPlan& plan)
{
  std::vector<Loop> borders;
  for (const PlanWall& wall : plan.unseen_walls)
    borders.push_back({wall.from, wall.to});
  for (const PlanRoom& room : plan.rooms)
    addOpenBorders(plan, room.outline, borders);
  return borders;
}

} // namespace pcl::acmap
