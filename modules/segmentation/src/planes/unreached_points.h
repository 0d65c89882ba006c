#pragma once

#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap::planes {

/** Points that are found near places, each once: what was found, or does not qualify, is
 * passed over until \ref restore. A region that grows by the points near its members
 * costs what it has, not this times the neighbours of a point. Points that are not
 * finite are left out. */
class UnreachedPoints {
public:
  /** \param[in] points must outlive this object
   * \param[in] radius metres, above 0 */
  UnreachedPoints(const LargeVector<Eigen::Vector3d>& points, double radius);

  /** Calls reach (j) for each point that is nearer to point i than the radius, was not
   * reached since \ref restore, and qualifies.
   * \param[in] qualifies (j), the same until \ref restore
   * \param[in] reach (j), in no order */
  template <typename Qualifies, typename Reach>
  void
  reachNear(std::int32_t i, const Qualifies& qualifies, const Reach& reach)
  {
    const Eigen::Vector3d& place = points_[static_cast<std::size_t>(i)];
    std::vector<std::uint32_t>& cubes = cubesAround(i);
    for (std::size_t k = 0; k < cubes.size();) {
      Cube& cube = cubes_[cubes[k]];
      for (std::uint32_t slot = cube.begin; slot < cube.unreached;) {
        const std::int32_t j = order_[slot];
        const bool leaves = !qualifies(j);
        if (leaves || (points_[static_cast<std::size_t>(j)] - place).squaredNorm() <
                          radius_ * radius_) {
          pass(cubes[k], slot);
          if (!leaves)
            reach(j);
        }
        else
          ++slot;
      }
      if (cube.unreached > cube.begin)
        ++k;
      else {
        cubes[k] = cubes.back();
        cubes.pop_back();
      }
    }
  }

  /** Point i is reached. */
  void
  reach(std::int32_t i);

  /** All points can be found again. */
  void
  restore();

  /** Point i, which is not reached, is never found again. */
  void
  remove(std::int32_t i);

private:
  using Place = std::array<std::int64_t, 3>;

  /** Its points are a part of the order: those that are not reached, then those that
   * are, then those that were removed. */
  struct Cube {
    Place place;
    std::uint32_t begin, unreached, end;
    bool is_asked = false, is_touched = false; ///< since the last restore
  };

  static constexpr std::int64_t cubes_of_radius = 4;

  Place
  placeOf(const Eigen::Vector3d& point) const;

  /** Cubes with points that are not reached and may be near the points of the cube of
   * point i. */
  std::vector<std::uint32_t>&
  cubesAround(std::int32_t i);

  /** Moves the point in a slot behind those that are not reached. */
  void
  pass(std::uint32_t cube, std::uint32_t slot);

  void
  swap(std::uint32_t a, std::uint32_t b);

  const LargeVector<Eigen::Vector3d>& points_;
  double radius_;
  std::vector<Cube> cubes_;                        ///< sorted by place
  std::vector<std::int32_t> order_;                ///< points by cube
  std::vector<std::uint32_t> slot_of_;             ///< of each point
  std::vector<std::uint32_t> cube_of_;             ///< of each point
  std::vector<std::vector<std::uint32_t>> around_; ///< of each cube that is asked
  std::vector<std::uint32_t> asked_, touched_;
};

} // namespace pcl::acmap::planes
