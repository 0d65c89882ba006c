#pragma once

#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl::acmap::planes {

/** Points in cubes with the radius as edge length: all points within the radius of a
 * position are in 27 of them. Points that are not finite are omitted. */
class RadiusGrid {
public:
  /** \param[in] points must outlive this object
   * \param[in] radius metres, above 0 */
  RadiusGrid(const LargeVector<Eigen::Vector3d>& points, double radius);

  /** Calls visit (number) for each point that is nearer than the radius; for none if
   * the position is not finite. */
  template <typename Visit>
  void
  visitNear(const Eigen::Vector3d& place, const Visit& visit) const
  {
    if (!place.allFinite())
      return;
    const Cube middle = cubeOf(place);
    for (std::int64_t x = middle.x - 1; x <= middle.x + 1; ++x)
      for (std::int64_t y = middle.y - 1; y <= middle.y + 1; ++y) {
        auto member = std::lower_bound(
            members_.begin(), members_.end(), Cube{x, y, middle.z - 1}, isBefore);
        for (; member != members_.end() && member->cube.x == x && member->cube.y == y &&
               member->cube.z <= middle.z + 1;
             ++member)
          if ((points_[static_cast<std::size_t>(member->point)] - place).squaredNorm() <
              radius_ * radius_)
            visit(member->point);
      }
  }

private:
  struct Cube {
    std::int64_t x, y, z;
  };

  struct Member {
    Cube cube;
    std::int32_t point;
  };

  static bool
  isBefore(const Member& member, const Cube& cube);

  Cube
  cubeOf(const Eigen::Vector3d& place) const;

  const LargeVector<Eigen::Vector3d>& points_;
  double radius_;
  std::vector<Member> members_; ///< sorted by cube, then by number
};

} // namespace pcl::acmap::planes
