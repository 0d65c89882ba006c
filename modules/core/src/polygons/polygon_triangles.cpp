#include <pcl/core/exceptions.h>
#include <pcl/core/polygon_triangles.h>

#include "polygons/polygon_ring.h"
#include "polygons/ring_crossings.h"

#include <algorithm>

namespace pcl {

namespace {

using acmap::GridPoint;
using acmap::RingNode;
using acmap::RingNodes;
using acmap::turn;

/** \brief Removes ears from a ring until it is empty. */
class EarClipping {
public:
  EarClipping(RingNodes& nodes, std::int32_t ring)
  : nodes_(nodes)
  , ring_(ring)
  {
    do {
      ++size_;
      ring = node(ring).next;
    } while (ring != ring_);
  }

  TriangleMesh::Triangles
  run()
  {
    // A corner that is not an ear stays blocked until one of its neighbours is removed.
    // This may be wrong if boundaries touch each other, so all corners are tested again
    // a few times. If there is still no ear, boundaries cross, and the smallest corner
    // is removed.
    constexpr int second_looks = 4;
    int looks = 0;
    dropFlat();
    while (size_ >= 3) {
      if (clipEars())
        continue;
      if (looks++ < second_looks)
        unblockAll();
      else
        clipSmallest();
    }
    return std::move(triangles_);
  }

private:
  struct Ear {
    Ear(const GridPoint& a, const GridPoint& b, const GridPoint& c)
    : corners{a, b, c}
    , minimum{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})}
    , maximum{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}
    {}

    bool
    mayHold(const GridPoint& p) const
    {
      return p.x >= minimum.x && p.x <= maximum.x && p.y >= minimum.y &&
             p.y <= maximum.y;
    }

    std::int64_t
    side(int edge, const GridPoint& p) const
    {
      return turn(corners[edge], corners[(edge + 1) % 3], p);
    }

    GridPoint corners[3];
    GridPoint minimum;
    GridPoint maximum;
  };

  RingNode&
  node(std::int32_t number)
  {
    return nodes_[static_cast<std::size_t>(number)];
  }

  const RingNode&
  node(std::int32_t number) const
  {
    return nodes_[static_cast<std::size_t>(number)];
  }

  std::int64_t
  turnAt(std::int32_t b) const
  {
    return turn(node(node(b).previous).point, node(b).point, node(node(b).next).point);
  }

  /** Walks around the ring until a complete round finds no ear.
   * \return true if any ear was found */
  bool
  clipEars()
  {
    bool found = false;
    std::int32_t b = ring_;
    for (std::size_t idle = 0; idle <= size_ && size_ >= 3; ++idle) {
      if (!node(b).blocked) {
        if (isEar(b)) {
          clip(b);
          found = true;
          idle = 0;
          b = node(ring_).next; // skip one, because long fans have thin triangles
          continue;
        }
        node(b).blocked = true;
      }
      b = node(b).next;
    }
    return found;
  }

  bool
  isEar(std::int32_t b) const
  {
    if (turnAt(b) <= 0)
      return false;
    const std::int32_t a = node(b).previous;
    const std::int32_t c = node(b).next;
    const Ear ear(node(a).point, node(b).point, node(c).point);
    bool is_touched = false;
    for (std::int32_t v = node(c).next; v != a; v = node(v).next)
      if (ear.mayHold(node(v).point)) {
        if (blocks(ear, v))
          return false;
        is_touched = is_touched || node(v).point == node(b).point;
      }
    // A boundary may return along both edges of the ear: the winding number tells
    // whether the ear or the area outside of it is inside.
    return !is_touched || windsRound(ear);
  }

  /** Returns true if the ring winds around the centre of an ear, for an ear into which
   * no boundary leads. */
  bool
  windsRound(const Ear& ear) const
  {
    const auto& [a, b, c] = ear.corners;
    // three times the centroid
    const GridPoint middle{a.x + b.x + c.x, a.y + b.y + c.y};
    int windings = 0;
    std::int32_t v = ring_;
    do {
      const GridPoint& from = node(v).point;
      v = node(v).next;
      windings += windingOf(from, node(v).point, middle);
    } while (v != ring_);
    return windings > 0;
  }

  /** Returns true if a corner is inside of the ear, or on its border with an adjacent
   * edge that leads inside. */
  bool
  blocks(const Ear& ear, std::int32_t v) const
  {
    bool on_edge[3];
    for (int edge = 0; edge < 3; ++edge) {
      const std::int64_t side = ear.side(edge, node(v).point);
      if (side < 0)
        return false;
      on_edge[edge] = side == 0;
    }
    const auto leads_inside = [&](const GridPoint& to) {
      for (int edge = 0; edge < 3; ++edge)
        if (on_edge[edge] && ear.side(edge, to) <= 0)
          return false;
      return true;
    };
    return leads_inside(node(node(v).previous).point) ||
           leads_inside(node(node(v).next).point);
  }

  void
  clip(std::int32_t b)
  {
    const std::int32_t a = node(b).previous;
    const std::int32_t c = node(b).next;
    triangles_.push_back({node(a).index, node(b).index, node(c).index});
    unlink(b);
    dropFlatAt(a);
    dropFlatAt(ring_);
  }

  void
  unlink(std::int32_t b)
  {
    RingNode& before = node(node(b).previous);
    RingNode& behind = node(node(b).next);
    before.next = node(b).next;
    behind.previous = node(b).previous;
    before.blocked = false;
    behind.blocked = false;
    ring_ = node(b).next;
    --size_;
  }

  /** Removes collinear corners before anything else, because inside and outside cannot
   * be distinguished at the tip of a spike. */
  void
  dropFlatAt(std::int32_t b)
  {
    while (size_ >= 3 && turnAt(b) == 0) {
      const std::int32_t a = node(b).previous;
      unlink(b);
      // Either neighbour may be collinear now; the next one is tested first.
      if (size_ >= 3 && turnAt(ring_) == 0)
        b = ring_;
      else
        b = a;
    }
  }

  void
  dropFlat()
  {
    std::int32_t b = ring_;
    for (std::size_t left = size_; left > 0 && size_ >= 3; --left) {
      const bool is_flat = turnAt(b) == 0;
      dropFlatAt(b);
      b = is_flat ? ring_ : node(b).next;
    }
  }

  void
  unblockAll()
  {
    std::int32_t v = ring_;
    do {
      node(v).blocked = false;
      v = node(v).next;
    } while (v != ring_);
  }

  void
  clipSmallest()
  {
    std::int32_t best = ring_;
    std::int64_t minimum = 0;
    std::int32_t v = ring_;
    do {
      const std::int64_t area = turnAt(v);
      if (area > 0 && (minimum == 0 || area < minimum)) {
        minimum = area;
        best = v;
      }
      v = node(v).next;
    } while (v != ring_);
    if (minimum > 0)
      clip(best);
    else
      unlink(best);
  }

  RingNodes& nodes_;
  std::int32_t ring_;
  std::size_t size_ = 0;
  TriangleMesh::Triangles triangles_;
};

} // namespace

TriangleMesh::Triangles
trianglesOfPolygon(const PlanePolygon& polygon, const Eigen::Vector3d& normal)
{
  if (!normal.allFinite() || normal.isZero(0))
    throw acmap::BadArgument("the normal of a polygon is zero or not finite");
  acmap::PolygonRings rings = acmap::ringsOf(polygon, normal);
  if (rings.rim < 0)
    return {};
  const acmap::RingCrossings crossings(rings);
  acmap::bridgeHoles(rings);
  return crossings.sound(EarClipping(rings.nodes, rings.rim).run());
}

std::vector<Eigen::Vector3f>
pointsOfPolygon(const PlanePolygon& polygon)
{
  std::vector<Eigen::Vector3f> points = polygon.outer;
  for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
    points.insert(points.end(), hole.begin(), hole.end());
  return points;
}

} // namespace pcl
