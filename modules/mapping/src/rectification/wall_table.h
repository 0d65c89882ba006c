#pragma once

#include <pcl/mapping/impl/rectification_kernel.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The wall points of one observation in one cell of the map. */
struct SeenWall {
  std::uint64_t cell;
  std::uint32_t observation, points;
  float normal_x, normal_z; ///< unit, in the map, towards the sensor; (0, 0): unknown
};

/** \brief Returns the cell, a cube, of a position in the map. \param[in] edge edge
 * length of a cell, metres */
std::uint64_t
wallCellOf(const Eigen::Vector2d& place, double y, double edge);

/** \brief Maximum distance of points from their sensor, metres: farther points do not
 * belong to a building. */
inline constexpr double longest_ray = 1000;

/** \brief Returns the walls of an observation, sorted by their cells.
 * \param[in] has_normals if true, only points with a horizontal normal are walls;
 * otherwise all points */
std::vector<SeenWall>
seenWalls(const LevelledPoints& seen,
          std::size_t observation,
          const PlanarPose& pose,
          double edge,
          bool has_normals);

/** \brief Hash table of walls by their cells. */
class WallTable {
public:
  explicit WallTable(std::vector<SeenWall> walls);

  template <typename Visit>
  void
  visit(std::uint64_t cell, const Visit& visit) const
  {
    std::size_t i = slots_[slotOf(cell)];
    for (; i && i <= walls_.size() && walls_[i - 1].cell == cell; ++i)
      visit(walls_[i - 1]);
  }

private:
  std::size_t
  slotOf(std::uint64_t cell) const;

  std::vector<SeenWall> walls_;
  std::vector<std::size_t> slots_; ///< 1 + index of a cell's first wall
};

} // namespace pcl::acmap
