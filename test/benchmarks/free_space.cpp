#include "free_space.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::bench {

void
FreeSpace::add(double x0, double z0, double x1, double z1)
{
  rectangles_.push_back(
      {{std::min(x0, x1), std::min(z0, z1)}, {std::max(x0, x1), std::max(z0, z1)}});
}

void
FreeSpace::addAround(const Eigen::Vector2d& from,
                     const Eigen::Vector2d& to,
                     double half_width)
{
  const Eigen::Vector2d margin(half_width, half_width);
  const Eigen::Vector2d low = from.cwiseMin(to) - margin;
  const Eigen::Vector2d high = from.cwiseMax(to) + margin;
  add(low[0], low[1], high[0], high[1]);
}

std::vector<double>
FreeSpace::limitsAlong(int axis) const
{
  std::vector<double> limits;
  for (const Rectangle& one : rectangles_) {
    limits.push_back(one.low[axis]);
    limits.push_back(one.high[axis]);
  }
  std::sort(limits.begin(), limits.end());
  limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
  return limits;
}

bool
FreeSpace::contains(const Eigen::Vector2d& place) const
{
  return std::any_of(rectangles_.begin(), rectangles_.end(), [&](const Rectangle& one) {
    return place[0] > one.low[0] && place[0] < one.high[0] && place[1] > one.low[1] &&
           place[1] < one.high[1];
  });
}

void
FreeSpace::addOutline(int axis, std::vector<BuildingWall>& walls) const
{
  const std::vector<double> across = limitsAlong(axis);
  const std::vector<double> along = limitsAlong(1 - axis);
  constexpr double aside = 1e-4; // metres
  for (const double at : across) {
    bool continues = false;
    for (std::size_t i = 1; i < along.size(); ++i) {
      Eigen::Vector2d place;
      place[1 - axis] = (along[i - 1] + along[i]) / 2;
      place[axis] = at - aside;
      const bool before = contains(place);
      place[axis] = at + aside;
      const bool is_wall = before != contains(place);
      if (is_wall && continues)
        walls.back().to[1 - axis] = along[i];
      else if (is_wall) {
        BuildingWall wall;
        wall.from[axis] = wall.to[axis] = at;
        wall.from[1 - axis] = along[i - 1];
        wall.to[1 - axis] = along[i];
        walls.push_back(wall);
      }
      continues = is_wall;
    }
  }
}

std::vector<BuildingWall>
FreeSpace::outline() const
{
  std::vector<BuildingWall> walls;
  addOutline(0, walls);
  addOutline(1, walls);
  return walls;
}

void
addWallsThrough(const std::vector<Eigen::Vector2d>& corners,
                std::vector<BuildingWall>& walls)
{
  for (std::size_t i = 1; i < corners.size(); ++i)
    walls.push_back({corners[i - 1], corners[i]});
}

std::vector<PlanarPose>
drive(const std::vector<Eigen::Vector2d>& corners, double step)
{
  constexpr double turn = 0.7; // radians
  std::vector<PlanarPose> path;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Eigen::Vector2d leg = corners[i] - corners[i - 1];
    if (leg.norm() < 1e-6)
      continue;
    const double heading = std::atan2(leg[0], leg[1]);
    if (!path.empty()) {
      const double left = std::remainder(heading - path.back().theta, 2 * M_PI);
      const int turns = static_cast<int>(std::abs(left) / turn);
      const PlanarPose last = path.back();
      for (int k = 1; k <= turns; ++k)
        path.push_back({last.x, last.z, last.theta + left * k / (turns + 1)});
    }
    const int steps = std::max(1, static_cast<int>(std::lround(leg.norm() / step)));
    for (int k = path.empty() ? 0 : 1; k <= steps; ++k) {
      const Eigen::Vector2d place = corners[i - 1] + leg * k / steps;
      path.push_back({place[0], place[1], heading});
    }
  }
  return path;
}

} // namespace pcl::acmap::bench
