#pragma once

#include <pcl/mapping/rectification_kernel.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief What one observation saw in one cell of the map: points of walls. */
struct SeenWall {
  std::uint64_t cell;
  std::uint32_t observation, points;
  float normal_x, normal_z; ///< unit, in the map, towards the sensor; 0, 0: not known
};

/** \brief The cell, a cube, of a place in the map. \param[in] edge of a cell, metres */
std::uint64_t
wallCellOf(const Eigen::Vector2d& place, double y, double edge);

/** \brief Points farther than this from their sensor are of no building. */
inline constexpr double longest_ray = 1000;

/** \brief Walls that an observation sees, in the order of their cells.
 * \param[in] has_normals only points with a level normal are walls; else all are */
std::vector<SeenWall>
seenWalls(const LevelledPoints& seen,
          std::size_t observation,
          const PlanarPose& pose,
          double edge,
          bool has_normals);

/** \brief Walls by their cell. */
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
  std::vector<std::size_t> slots_; ///< 1 + position of a cell's first wall
};

} // namespace pcl::acmap
