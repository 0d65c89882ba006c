#include "polygons/ring_crossings.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

using Corners = GridPoint[3];

__extension__ using Wide = __int128;

int
signOf(std::int64_t number)
{
  return (number > 0) - (number < 0);
}

/** Do segments ab and cd cross each other? */
bool
doCross(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
  return signOf(turn(a, b, c)) * signOf(turn(a, b, d)) < 0 &&
         signOf(turn(c, d, a)) * signOf(turn(c, d, b)) < 0;
}

/** Does the line of an edge of the triangle separate it from all points? Convex shapes
 * that do not overlap are separated by the line of one of their edges. */
bool
isParted(const Corners& triangle, const GridPoint* other, int size)
{
  for (int k = 0; k < 3; ++k)
    if (std::all_of(other, other + size, [&](const GridPoint& p) {
          return turn(triangle[k], triangle[(k + 1) % 3], p) <= 0;
        }))
      return true;
  return false;
}

bool
doOverlap(const Corners& a, const Corners& b)
{
  return !isParted(a, b, 3) && !isParted(b, a, 3);
}

/** Does a segment pass through the inside of a triangle? */
bool
leadsThrough(const GridPoint& from, const GridPoint& to, const Corners& triangle)
{
  const GridPoint ends[2] = {from, to};
  if (isParted(triangle, ends, 2))
    return false;
  int minimum = 1, maximum = -1;
  for (const GridPoint& corner : triangle) {
    const int side = signOf(turn(from, to, corner));
    minimum = std::min(minimum, side);
    maximum = std::max(maximum, side);
  }
  return minimum < 0 && maximum > 0;
}

} // namespace

RingCrossings::RingCrossings(const PolygonRings& rings)
{
  for (const RingNode& node : rings.nodes) {
    const GridPoint& next = rings.nodes[static_cast<std::size_t>(node.next)].point;
    edges_.push_back({node.point, next});
    if (points_.size() <= static_cast<std::size_t>(node.index))
      points_.resize(static_cast<std::size_t>(node.index) + 1);
    points_[static_cast<std::size_t>(node.index)] = node.point;
  }
  for (const auto& [from, to] : edges_)
    twice_area_ += Wide(from.x) * to.y - Wide(to.x) * from.y;
  std::stable_sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
    return std::min(a.from.x, a.to.x) < std::min(b.from.x, b.to.x);
  });
  any_ = findCrossing();
}

bool
RingCrossings::findCrossing() const
{
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = edges_[i];
    const std::int64_t right = std::max(e.from.x, e.to.x);
    const std::int64_t low = std::min(e.from.y, e.to.y);
    const std::int64_t high = std::max(e.from.y, e.to.y);
    for (std::size_t k = i + 1; k < edges_.size(); ++k) {
      const Edge& f = edges_[k];
      if (std::min(f.from.x, f.to.x) > right)
        break;
      if (std::max(f.from.y, f.to.y) >= low && std::min(f.from.y, f.to.y) <= high &&
          doCross(e.from, e.to, f.from, f.to))
        return true;
    }
  }
  return false;
}

/** Boundaries may also cross in corners; then the areas differ. */
bool
RingCrossings::isWhole(const TriangleMesh::Triangles& triangles) const
{
  const auto point = [&](std::int32_t corner) {
    return points_[static_cast<std::size_t>(corner)];
  };
  Wide twice_area = 0;
  for (const auto& [a, b, c] : triangles)
    twice_area += turn(point(a), point(b), point(c));
  return twice_area == twice_area_;
}

bool
RingCrossings::isInside(const GridPoint (&corners)[3]) const
{
  const auto& [a, b, c] = corners;
  const GridPoint middle{a.x + b.x + c.x, a.y + b.y + c.y}; // three times the centroid
  int windings = 0;
  for (const auto& [from, to] : edges_) {
    if (leadsThrough(from, to, corners))
      return false;
    windings += windingOf(from, to, middle);
  }
  return windings > 0;
}

TriangleMesh::Triangles
RingCrossings::sound(TriangleMesh::Triangles triangles) const
{
  if (!any_ && isWhole(triangles))
    return triangles;
  TriangleMesh::Triangles kept;
  for (const TriangleMesh::Triangle& triangle : triangles) {
    const auto cornersOf = [&](const TriangleMesh::Triangle& t, Corners& corners) {
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = points_[static_cast<std::size_t>(t[k])];
    };
    Corners corners;
    cornersOf(triangle, corners);
    const bool is_free = std::none_of(kept.begin(), kept.end(), [&](const auto& other) {
      Corners others;
      cornersOf(other, others);
      return doOverlap(corners, others);
    });
    if (is_free && isInside(corners))
      kept.push_back(triangle);
  }
  return kept;
}

} // namespace pcl::acmap
