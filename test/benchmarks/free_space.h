#pragma once

#include "guard_buildings.h"

#include <vector>

namespace pcl::acmap::bench {

/** \brief The floor of a building as a union of rectangles along the axes; its walls are
 * the outline of the union. */
class FreeSpace {
public:
  /** \brief Adds a rectangle between two opposite corners, metres. */
  void
  add(double x0, double z0, double x1, double z1);

  /** \brief Adds a rectangle about a line along one of the axes. */
  void
  addAround(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double half_width);

  std::vector<BuildingWall>
  outline() const;

private:
  struct Rectangle {
    double low[2], high[2];
  };

  /** Adds the walls perpendicular to an axis. */
  void
  addOutline(int axis, std::vector<BuildingWall>& walls) const;

  std::vector<double>
  limitsAlong(int axis) const;

  bool
  contains(const Eigen::Vector2d& place) const;

  std::vector<Rectangle> rectangles_;
};

/** \brief Adds walls between consecutive corners. */
void
addWallsThrough(const std::vector<Eigen::Vector2d>& corners,
                std::vector<BuildingWall>& walls);

/** \brief Poses through corners, facing in the direction of motion; the robot turns in
 * place, at most 0.7 rad from scan to scan. \param[in] step metres */
std::vector<PlanarPose>
drive(const std::vector<Eigen::Vector2d>& corners, double step);

} // namespace pcl::acmap::bench
