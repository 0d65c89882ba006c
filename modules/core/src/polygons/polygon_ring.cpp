#include "polygons/polygon_ring.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** \brief Projects the points of a polygon to the grid. */
class Grid {
public:
  Grid(const PlanePolygon& polygon, const Eigen::Vector3d& normal)
  {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    first_ = (axis + 1) % 3;
    second_ = (axis + 2) % 3;
    if (normal[axis] < 0)
      std::swap(first_, second_);
    extend(polygon.outer);
    for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
      extend(hole);
    const double extent = (maximum_ - minimum_).maxCoeff();
    // A power of two: most points are exactly on the grid, and straight edges stay
    // straight.
    scale_ = extent > 0 ? std::ldexp(1.0, 29 - std::ilogb(extent)) : 0.0;
  }

  GridPoint
  operator()(const Eigen::Vector3f& point) const
  {
    return {std::llround((point[first_] - minimum_.x()) * scale_),
            std::llround((point[second_] - minimum_.y()) * scale_)};
  }

private:
  void
  extend(const std::vector<Eigen::Vector3f>& loop)
  {
    for (const Eigen::Vector3f& p : loop)
      if (p.allFinite()) {
        const Eigen::Vector2d place(p[first_], p[second_]);
        minimum_ = empty_ ? place : Eigen::Vector2d(minimum_.cwiseMin(place));
        maximum_ = empty_ ? place : Eigen::Vector2d(maximum_.cwiseMax(place));
        empty_ = false;
      }
  }

  int first_ = 0;
  int second_ = 1;
  bool empty_ = true;
  Eigen::Vector2d minimum_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d maximum_ = Eigen::Vector2d::Zero();
  double scale_ = 0;
};

/** Twice the area, up to rounding; its sign is the orientation of the loop. */
double
signedArea(const std::vector<RingNode>& loop)
{
  double area = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    area += static_cast<double>(turn(loop[0].point, loop[i].point, loop[i + 1].point));
  return area;
}

/** Removes duplicate points, collinear points and spikes: inside and outside cannot be
 * distinguished where a boundary turns back. */
std::vector<RingNode>
withoutFlat(const std::vector<RingNode>& loop)
{
  std::vector<RingNode> kept;
  const auto isFlat = [&](std::size_t a, std::size_t b, std::size_t c) {
    return turn(kept[a].point, kept[b].point, kept[c].point) == 0;
  };
  for (const RingNode& node : loop) {
    kept.push_back(node);
    for (std::size_t n = kept.size(); n >= 3 && isFlat(n - 3, n - 2, n - 1); --n)
      kept.erase(kept.end() - 2);
  }
  for (std::size_t n = kept.size(); n >= 3; n = kept.size()) {
    if (isFlat(n - 2, n - 1, 0))
      kept.pop_back();
    else if (isFlat(n - 1, 0, 1))
      kept.erase(kept.begin());
    else
      break;
  }
  return kept;
}

/** Appends a loop as a ring, counter-clockwise if \a left is true.
 * \return its first node, -1 if it has no area */
std::int32_t
appendRing(RingNodes& nodes,
           const Grid& grid,
           const std::vector<Eigen::Vector3f>& points,
           std::int32_t first_index,
           bool left)
{
  std::vector<RingNode> loop;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite())
      continue;
    RingNode node;
    node.point = grid(points[i]);
    node.index = first_index + static_cast<std::int32_t>(i);
    loop.push_back(node);
  }
  loop = withoutFlat(loop);
  const double area = signedArea(loop);
  if (loop.size() < 3 || area == 0)
    return -1;
  if ((area > 0) != left)
    std::reverse(loop.begin(), loop.end());
  const auto first = static_cast<std::int32_t>(nodes.size());
  const auto size = static_cast<std::int32_t>(loop.size());
  for (std::int32_t i = 0; i < size; ++i) {
    RingNode& node = loop[static_cast<std::size_t>(i)];
    node.previous = first + (i + size - 1) % size;
    node.next = first + (i + 1) % size;
    nodes.push_back(node);
  }
  return first;
}

} // namespace

PolygonRings
ringsOf(const PlanePolygon& polygon, const Eigen::Vector3d& normal)
{
  const Grid grid(polygon, normal);
  PolygonRings rings;
  rings.rim = appendRing(rings.nodes, grid, polygon.outer, 0, true);
  auto first = static_cast<std::int32_t>(polygon.outer.size());
  for (const std::vector<Eigen::Vector3f>& hole : polygon.holes) {
    const std::int32_t ring = appendRing(rings.nodes, grid, hole, first, false);
    if (ring >= 0)
      rings.holes.push_back(ring);
    first += static_cast<std::int32_t>(hole.size());
  }
  return rings;
}

} // namespace pcl::acmap
