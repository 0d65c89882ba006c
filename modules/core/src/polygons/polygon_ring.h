#pragma once

#include <pcl/core/plane_patch.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A point of the grid, 0 to 2^30 along each axis. */
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;

  bool
  operator==(const GridPoint& other) const
  {
    return x == other.x && y == other.y;
  }
};

/** \brief Twice the signed area of the triangle a, b, c; positive if it is
 * counter-clockwise. Exact. */
inline std::int64_t
turn(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/** \brief Contribution of an edge to the winding number about a point: -1, 0 or 1.
 * Exact.
 * \param[in] from, to the edge
 * \param[in] thrice three times the point, because the centroid of a triangle is not on
 * the grid */
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

/** \brief A node of a ring. */
struct RingNode {
  GridPoint point;
  std::int32_t index = 0; ///< index of the point in the polygon
  std::int32_t previous = 0;
  std::int32_t next = 0;
  bool blocked = false; ///< not an ear, as far as is known
};

/** \brief Rings of nodes, each linked to the previous and to the next one. The inside
 * is on the left. */
using RingNodes = std::vector<RingNode>;

/** \brief A polygon on the grid: a node of its outer boundary, and one of each hole. */
struct PolygonRings {
  RingNodes nodes;
  std::int32_t rim = -1; ///< a node of the outer boundary; -1 if there is none
  std::vector<std::int32_t> holes;
};

/** \brief Projects a polygon to the grid along the axis closest to its normal. */
PolygonRings
ringsOf(const PlanePolygon& polygon, const Eigen::Vector3d& normal);

/** \brief Connects each hole to the outer boundary by a bridge, so that one ring is
 * left; holes that are not inside stay separate. */
void
bridgeHoles(PolygonRings& rings);

} // namespace pcl::acmap
