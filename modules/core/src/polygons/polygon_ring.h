#pragma once

#include <pcl/core/plane_patch.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A place on the grid, 0 to 2^30 each way. */
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;

  bool
  operator==(const GridPoint& other) const
  {
    return x == other.x && y == other.y;
  }
};

/** \brief Twice the area of a, b, c; above zero where they turn left. Exact. */
inline std::int64_t
turn(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/** \brief What an edge adds to the winding number about a place: -1, 0 or 1. Exact.
 * \param[in] thrice three times the place, as the middle of a triangle is on no grid */
inline int
windingOf(const GridPoint& from, const GridPoint& to, const GridPoint& thrice)
{
  __extension__ using Wide = __int128;
  const bool is_above = 3 * to.y > thrice.y;
  if ((3 * from.y > thrice.y) == is_above)
    return 0;
  const Wide side = Wide(to.x - from.x) * (thrice.y - 3 * from.y) -
                    Wide(to.y - from.y) * (thrice.x - 3 * from.x);
  if (side == 0 || (side > 0) != is_above)
    return 0;
  return is_above ? 1 : -1;
}

/** \brief A corner of a ring. */
struct RingNode {
  GridPoint point;
  std::int32_t index = 0; ///< of the polygon's point
  std::int32_t previous = 0;
  std::int32_t next = 0;
  bool blocked = false; ///< is no ear, as far as is known
};

/** \brief Rings of corners, each linked to the ones before and behind it. The inside lies
 * to the left. */
using RingNodes = std::vector<RingNode>;

/** \brief A polygon on the grid: its rim, from any of its nodes, and its holes. */
struct PolygonRings {
  RingNodes nodes;
  std::int32_t rim = -1; ///< a node of it; -1 for none
  std::vector<std::int32_t> holes;
};

/** \brief Puts a polygon on the grid, seen along the axis nearest to its normal. */
PolygonRings
ringsOf(const PlanePolygon& polygon, const Eigen::Vector3d& normal);

/** \brief Cuts from each hole to the rim, so that one ring is left; holes that do not lie
 * inside stay apart. */
void
bridgeHoles(PolygonRings& rings);

} // namespace pcl::acmap
