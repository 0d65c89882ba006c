#include "polygons/polygon_ring.h"

#include <algorithm>
#include <cstdlib>

namespace pcl::acmap {

namespace {

__extension__ using Wide = __int128;

RingNode&
at(RingNodes& nodes, std::int32_t node)
{
  return nodes[static_cast<std::size_t>(node)];
}

const RingNode&
at(const RingNodes& nodes, std::int32_t node)
{
  return nodes[static_cast<std::size_t>(node)];
}

bool
isLeftOf(const GridPoint& a, const GridPoint& b)
{
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

std::int32_t
leftmost(const RingNodes& nodes, std::int32_t ring)
{
  std::int32_t best = ring;
  for (std::int32_t node = at(nodes, ring).next; node != ring;
       node = at(nodes, node).next)
    if (isLeftOf(at(nodes, node).point, at(nodes, best).point))
      best = node;
  return best;
}

/** Intersection of a falling edge with the horizontal line through a point; its x is
 * numerator / denominator. */
struct Meeting {
  Wide numerator = 0;
  Wide denominator = 1;

  Meeting(const GridPoint& a, const GridPoint& b, std::int64_t y)
  : numerator(Wide(a.x) * (a.y - b.y) + Wide(b.x - a.x) * (a.y - y))
  , denominator(a.y - b.y)
  {}

  bool
  isRightOf(const Meeting& other) const
  {
    return numerator * other.denominator > other.numerator * denominator;
  }
};

/** Returns the first edge to the left of a point, by its first node; -1 if there is
 * none. Only falling edges are considered, which have the inside on the side of the
 * point. */
std::int32_t
edgeOnTheLeft(const RingNodes& nodes, std::int32_t ring, const GridPoint& point)
{
  std::int32_t best = -1;
  Meeting best_meeting({0, 1}, {0, 0}, 0);
  std::int32_t node = ring;
  do {
    const RingNode& from = at(nodes, node);
    const GridPoint& a = from.point;
    const GridPoint& b = at(nodes, from.next).point;
    if (a.y >= point.y && point.y >= b.y && a.y > b.y && turn(a, b, point) >= 0) {
      const Meeting meeting(a, b, point.y);
      if (best < 0 || meeting.isRightOf(best_meeting)) {
        best = node;
        best_meeting = meeting;
      }
    }
    node = from.next;
  } while (node != ring);
  return best;
}

/** Position of the closest node before or after a node that differs from its own
 * position; bridges may have zero length. */
const GridPoint&
neighbour(const RingNodes& nodes, std::int32_t node, std::int32_t RingNode::*step)
{
  std::int32_t other = at(nodes, node).*step;
  while (other != node && at(nodes, other).point == at(nodes, node).point)
    other = at(nodes, other).*step;
  return at(nodes, other).point;
}

enum class Way { Outside, Along, Inside };

/** Location of the start of the segment from a node to a point: outside of the ring,
 * along its boundary, or inside. */
Way
wayFrom(const RingNodes& nodes, std::int32_t node, const GridPoint& point)
{
  const RingNode& v = at(nodes, node);
  const GridPoint& a = neighbour(nodes, node, &RingNode::previous);
  const GridPoint& b = neighbour(nodes, node, &RingNode::next);
  const std::int64_t in = turn(a, v.point, point);
  const std::int64_t out = turn(v.point, b, point);
  const std::int64_t side =
      turn(a, v.point, b) > 0 ? std::min(in, out) : std::max(in, out);
  return side > 0 ? Way::Inside : side == 0 ? Way::Along : Way::Outside;
}

/** \brief Selects the corner to which a hole is connected by a bridge: among the
 * corners that are visible from the leftmost point of the hole, the one whose direction
 * is closest to that to the left. */
class BridgeEnd {
public:
  BridgeEnd(const RingNodes& nodes, std::int32_t hole, std::int32_t edge)
  : nodes_(nodes)
  , from_(at(nodes, hole).point)
  , ahead_(at(nodes, at(nodes, hole).next).point)
  , a_(at(nodes, edge).point)
  , b_(at(nodes, at(nodes, edge).next).point)
  , end_(isLeftOf(a_, b_) ? a_ : b_)
  {}

  std::int32_t
  choose(std::int32_t ring)
  {
    std::int32_t node = ring;
    do {
      consider(node);
      node = at(nodes_, node).next;
    } while (node != ring);
    return best_;
  }

private:
  /** Is the corner in the triangle of the point of the hole, the left end of the edge,
   * and the intersection of the edge with the horizontal line to the left? */
  bool
  isInReach(const GridPoint& v) const
  {
    if (v.x > from_.x || turn(a_, b_, v) < 0)
      return false;
    if (end_.y >= from_.y)
      return v.y >= from_.y && v.y <= end_.y && turn(from_, end_, v) >= 0;
    return v.y <= from_.y && v.y >= end_.y && turn(from_, end_, v) <= 0;
  }

  bool
  isBetter(const GridPoint& v) const
  {
    const GridPoint& best = at(nodes_, best_).point;
    if (best == from_ || v == from_)
      return !(best == from_);
    const std::int64_t side = turn(from_, best, v);
    if (side != 0)
      return (side > 0) == (end_.y >= from_.y);
    return std::abs(v.x - from_.x) + std::abs(v.y - from_.y) <
           std::abs(best.x - from_.x) + std::abs(best.y - from_.y);
  }

  void
  consider(std::int32_t node)
  {
    const GridPoint& v = at(nodes_, node).point;
    if (!isInReach(v))
      return;
    // If the hole touches the corner, the hole itself must be inside.
    const Way way = wayFrom(nodes_, node, v == from_ ? ahead_ : from_);
    if (way == Way::Outside)
      return;
    const bool is_same = best_ >= 0 && at(nodes_, best_).point == v;
    if (best_ < 0 || (is_same ? way > best_way_ : isBetter(v))) {
      best_ = node;
      best_way_ = way;
    }
  }

  const RingNodes& nodes_;
  const GridPoint from_;
  const GridPoint ahead_;
  const GridPoint a_;
  const GridPoint b_;
  const GridPoint end_;
  std::int32_t best_ = -1;
  Way best_way_ = Way::Outside;
};

/** Inserts a bridge from the corner to the hole, around it and back. */
void
bridge(RingNodes& nodes, std::int32_t corner, std::int32_t hole)
{
  const auto corner_again = static_cast<std::int32_t>(nodes.size());
  const std::int32_t hole_again = corner_again + 1;
  nodes.push_back(RingNode(at(nodes, corner)));
  nodes.push_back(RingNode(at(nodes, hole)));
  at(nodes, at(nodes, corner).next).previous = corner_again;
  at(nodes, at(nodes, hole).previous).next = hole_again;
  at(nodes, corner).next = hole;
  at(nodes, hole).previous = corner;
  at(nodes, hole_again).next = corner_again;
  at(nodes, corner_again).previous = hole_again;
}

} // namespace

void
bridgeHoles(PolygonRings& rings)
{
  RingNodes& nodes = rings.nodes;
  // From left to right, so that only the ring built so far is left of a hole.
  for (std::int32_t& hole : rings.holes)
    hole = leftmost(nodes, hole);
  std::stable_sort(
      rings.holes.begin(), rings.holes.end(), [&](std::int32_t a, std::int32_t b) {
        return isLeftOf(at(nodes, a).point, at(nodes, b).point);
      });
  for (const std::int32_t hole : rings.holes) {
    const std::int32_t edge = edgeOnTheLeft(nodes, rings.rim, at(nodes, hole).point);
    if (edge < 0)
      continue;
    const std::int32_t corner = BridgeEnd(nodes, hole, edge).choose(rings.rim);
    if (corner >= 0)
      bridge(nodes, corner, hole);
  }
}

} // namespace pcl::acmap
