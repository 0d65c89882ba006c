#include "wall_table.h"

#include "../entropy/planar_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::acmap {
namespace {

/** The normal of a wall, in the map and towards the sensor; none for floors. */
std::optional<Eigen::Vector2d>
wallNormal(const LevelledPoints& seen, std::size_t i, const PlanarMotion& motion)
{
  if (seen.normals.empty())
    return {};
  const Eigen::Vector3d normal = seen.normals[i].cast<double>();
  const Eigen::Vector2d level(normal[0], normal[2]);
  if (!normal.allFinite() || !(level.norm() > std::abs(normal[1])))
    return {};
  const bool away =
      level.dot(Eigen::Vector2d(seen.points[i][0], seen.points[i][2])) > 0;
  return motion.rotation() * (away ? -level : level).normalized();
}

/** Merges the walls of one observation in the same cell. */
void
merge(std::vector<SeenWall>& walls)
{
  std::stable_sort(
      walls.begin(), walls.end(), [](const SeenWall& a, const SeenWall& b) {
        return a.cell < b.cell;
      });
  std::size_t kept = 0;
  for (const SeenWall& wall : walls)
    if (kept && walls[kept - 1].cell == wall.cell) {
      ++walls[kept - 1].points;
      walls[kept - 1].normal_x += wall.normal_x;
      walls[kept - 1].normal_z += wall.normal_z;
    }
    else
      walls[kept++] = wall;
  walls.resize(kept);
  for (SeenWall& wall : walls) {
    const float length = std::max(1e-6F, std::hypot(wall.normal_x, wall.normal_z));
    wall.normal_x /= length;
    wall.normal_z /= length;
  }
}

} // namespace

std::uint64_t
wallCellOf(const Eigen::Vector2d& place, double y, double edge)
{
  const auto part = [edge](double value) {
    return static_cast<std::uint64_t>(
               static_cast<std::int64_t>(std::floor(value / edge))) &
           0x1fffff;
  };
  return part(place[0]) << 42 | part(y) << 21 | part(place[1]);
}

std::vector<SeenWall>
seenWalls(const LevelledPoints& seen,
          std::size_t observation,
          const PlanarPose& pose,
          double edge,
          bool has_normals)
{
  const PlanarMotion motion(pose);
  std::vector<SeenWall> walls;
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    const Eigen::Vector3d point = seen.points[i].cast<double>();
    const auto normal = has_normals ? wallNormal(seen, i, motion)
                                    : std::make_optional<Eigen::Vector2d>(0, 0);
    if (!normal || !(point.norm() <= longest_ray))
      continue;
    walls.push_back({wallCellOf(motion.place(point[0], point[2]), point[1], edge),
                     static_cast<std::uint32_t>(observation),
                     1,
                     static_cast<float>((*normal)[0]),
                     static_cast<float>((*normal)[1])});
  }
  merge(walls);
  return walls;
}

WallTable::WallTable(std::vector<SeenWall> walls)
: walls_(std::move(walls))
{
  std::sort(walls_.begin(), walls_.end(), [](const SeenWall& a, const SeenWall& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.observation < b.observation;
  });
  std::size_t size = 16;
  while (size < 2 * walls_.size())
    size *= 2;
  slots_.assign(size, 0);
  for (std::size_t i = 0; i < walls_.size(); ++i)
    if (i == 0 || walls_[i].cell != walls_[i - 1].cell)
      slots_[slotOf(walls_[i].cell)] = i + 1;
}

std::size_t
WallTable::slotOf(std::uint64_t cell) const
{
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = (cell * 0x9e3779b97f4a7c15u >> 20) & mask;
  while (slots_[slot] && walls_[slots_[slot] - 1].cell != cell)
    slot = (slot + 1) & mask;
  return slot;
}

} // namespace pcl::acmap
