#include "growing_mesh.h"

#include "predicates.h"

#include <pcl/core/impl/parallel.h>

namespace pcl::acmap::ACMAP_DEWALL {

Eigen::Vector3f
GrowingMesh::areaVector(const std::array<std::int32_t, 3>& corners) const
{
  const Eigen::Vector3d a = tree_.position(corners[0]), b = tree_.position(corners[1]),
                        c = tree_.position(corners[2]);
  const Eigen::Vector3d area = (b - a).cross(c - a);
  const double longest = std::max(
      (a - b).squaredNorm(), std::max((a - c).squaredNorm(), (b - c).squaredNorm()));
  return (area / longest).cast<float>();
}

bool
GrowingMesh::isOdd(const Side& side, std::int32_t apex, std::int32_t component)
{
  const Eigen::Vector3f area = areaVector({side.b, side.a, apex});
  const float plumpness = area.norm();
  if (plumpness < static_cast<float>(min_plumpness))
    return true;
  const ParityUnion::Root own = parity_.find(component);
  for (const std::int32_t end : {side.a, side.b}) {
    const Vertex& v = vertex(end);
    const ParityUnion::Root root = parity_.find(v.component);
    const float along =
        v.normal.dot(area) * (root.flipped != own.flipped ? -1.0f : 1.0f);
    if (root.component == own.component &&
        along < static_cast<float>(cos_gentle_turn) * v.normal.norm() * plumpness)
      return true;
  }
  return false;
}

GrowingMesh::Demands
GrowingMesh::demands(const Side& side,
                     std::int32_t apex,
                     const Edge* base,
                     const Edge* at_a,
                     const Edge* at_b)
{
  Demands all;
  // Neighbours have the same orientation if they traverse their common edge in opposite
  // directions.
  const auto demand = [&](const Edge* edge, bool ascending) {
    if (!edge || !edge->isOpen())
      return;
    const ParityUnion::Root root = parity_.find(edge->componentNumber());
    all.of[all.count++] = {root.component,
                           root.flipped != (bool(edge->ascending) == ascending)};
  };
  demand(base, side.b < side.a);
  demand(at_a, side.a < apex);
  demand(at_b, apex < side.b);
  return all;
}

GrowingMesh::Bridge
GrowingMesh::bridge(const Side& side, std::int32_t apex)
{
  const Demands all = demands(side,
                              apex,
                              arrays_.find(side.a, side.b),
                              arrays_.find(side.a, apex),
                              arrays_.find(side.b, apex));
  for (std::size_t i = 1; i < all.count; ++i)
    if (all.of[i].root != all.of[0].root)
      return {std::min(all.of[i].root, all.of[0].root),
              std::max(all.of[i].root, all.of[0].root),
              all.of[i].flipped != all.of[0].flipped};
  return {};
}

bool
GrowingMesh::isOrientable(const Demands& all) const
{
  // All components are already oriented by it, so none may be flipped.
  if (facing_.isKnown())
    return std::none_of(all.of.begin(),
                        all.of.begin() + static_cast<std::ptrdiff_t>(all.count),
                        [](const Demands::Demand& demand) { return demand.flipped; });
  for (std::size_t i = 1; i < all.count; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (all.of[i].root == all.of[j].root && all.of[i].flipped != all.of[j].flipped)
        return false;
  return true;
}

double
GrowingMesh::steepestCosine(const Side& side,
                            std::int32_t apex,
                            const Edge* base,
                            const Edge* at_a,
                            const Edge* at_b) const
{
  const Eigen::Vector3d a = tree_.position(side.a), b = tree_.position(side.b),
                        p = tree_.position(apex);
  double minimum = cosineOfTurn(a, b, tree_.position(base->opposites), p);
  if (at_a)
    minimum = std::min(minimum, cosineOfTurn(a, p, tree_.position(at_a->opposites), b));
  if (at_b)
    minimum = std::min(minimum, cosineOfTurn(b, p, tree_.position(at_b->opposites), a));
  return minimum;
}

GrowingMesh::Verdict
GrowingMesh::judge(const Side& side, std::int32_t apex)
{
  const Edge* at_a = arrays_.find(side.a, apex);
  const Edge* at_b = arrays_.find(side.b, apex);
  if ((at_a && !at_a->isOpen()) || (at_b && !at_b->isOpen()))
    return Verdict::Blocked;
  // At most one pinch per vertex is permitted, because most are removed later.
  if (!at_a && !at_b && isUsed(apex))
    return vertex(apex).open_edges == 2 ? Verdict::Pinches : Verdict::Blocked;
  const Edge* base = arrays_.find(side.a, side.b);
  const double cosine = steepestCosine(side, apex, base, at_a, at_b);
  if (cosine <= cos_largest_turn)
    return Verdict::Blocked;
  if ((at_a || at_b) && !isOrientable(demands(side, apex, base, at_a, at_b))) {
    ++refused_moebius_;
    return Verdict::Blocked;
  }
  return cosine < cos_gentle_turn || isOdd(side, apex, base->componentNumber())
             ? Verdict::Doubtful
             : Verdict::Fits;
}

void
GrowingMesh::attach(std::int32_t from,
                    std::int32_t to,
                    std::int32_t opposite,
                    std::int32_t component)
{
  const bool ascending = from < to;
  Edge* edge = arrays_.find(from, to);
  if (!edge) {
    std::int32_t& first = vertex(std::min(from, to)).first_edge;
    const std::int32_t index = new_edges_.take();
    edge = &arrays_.edges[index];
    *edge = {std::max(from, to), first, opposite, 0, ascending, 0};
    edge->setComponent(component);
    first = index;
    vertex(from).addOpenEdges(1);
    vertex(to).addOpenEdges(1);
  }
  else if (edge->isOpen()) {
    const std::int32_t first = edge->componentNumber();
    const bool flipped = bool(edge->ascending) == ascending;
    if (parity_.unite(first, component, flipped))
      joints_.push_back({first, component, flipped});
    edge->opposites ^= opposite;
    vertex(from).addOpenEdges(-1);
    vertex(to).addOpenEdges(-1);
  }
  ++edge->triangles;
}

void
GrowingMesh::detachEdge(std::int32_t from, std::int32_t to, std::int32_t opposite)
{
  Edge& edge = *arrays_.find(from, to);
  const int change = edge.isOpen() ? -1 : 1;
  vertex(from).addOpenEdges(change);
  vertex(to).addOpenEdges(change);
  edge.opposites ^= opposite;
  if (--edge.triangles == 0)
    new_edges_.giveBack(arrays_.unlink(from, to));
}

void
GrowingMesh::reassignEdges(const std::vector<GrownTriangle>& triangles)
{
  for (const GrownTriangle& triangle : triangles)
    for (const Side& side : sidesOf(triangle)) {
      const Vertex &start = vertex(side.a), &end = vertex(side.b);
      if (!start.has_lost || !end.has_lost || start.open_edges == 0 ||
          end.open_edges == 0)
        continue;
      Edge& edge = *arrays_.find(side.a, side.b);
      if (edge.isOpen()) {
        edge.setComponent(triangle.component);
        edge.ascending = side.a < side.b;
      }
    }
}

void
GrowingMesh::sweep(const std::vector<std::vector<GrownTriangle>*>& lists)
{
  oneapi::tbb::parallel_for(std::size_t{0}, lists.size(), [&](std::size_t l) {
    std::vector<GrownTriangle>& list = *lists[l];
    list.erase(std::remove_if(list.begin(),
                              list.end(),
                              [](const GrownTriangle& t) { return t.isTakenOut(); }),
               list.end());
    reassignEdges(list);
  });
}

void
GrowingMesh::put(const GrownTriangle& triangle)
{
  const auto [a, b, c] = triangle.corners;
  attach(a, b, c, triangle.component);
  attach(b, c, a, triangle.component);
  attach(c, a, b, triangle.component);
  const Eigen::Vector3f area = areaVector(triangle.corners);
  const ParityUnion::Root own = parity_.find(triangle.component);
  for (const std::int32_t corner : triangle.corners) {
    Vertex& v = vertex(corner);
    v.was_pinched |= v.open_edges > 2;
    v.is_mixed |= v.triangles > 0 && v.component != triangle.component;
    v.is_of_wall |= is_of_wall_;
    if (v.triangles == 0) {
      v.component = triangle.component;
      v.normal.setZero();
      arrays_.noteUse(corner, true);
    }
    if (v.triangles < 0xffff)
      ++v.triangles;
    const ParityUnion::Root root = parity_.find(v.component);
    if (root.component == own.component)
      v.normal += root.flipped != own.flipped ? Eigen::Vector3f(-area) : area;
    if (v.open_edges == 0)
      arrays_.noteSaturation(corner, true);
  }
}

void
GrowingMesh::takeOut(GrownTriangle& triangle)
{
  const auto [a, b, c] = triangle.corners;
  detachEdge(a, b, c);
  detachEdge(b, c, a);
  detachEdge(c, a, b);
  for (const std::int32_t corner : triangle.corners) {
    Vertex& v = vertex(corner);
    v.has_lost = true;
    v.was_pinched = true; // its fan may be split by the removal
    if (--v.triangles == 0)
      arrays_.noteUse(corner, false);
    arrays_.noteSaturation(corner, v.triangles > 0 && v.open_edges == 0);
  }
  triangle.component = -1;
}

void
GrowingMesh::add(const Side& side, std::int32_t apex)
{
  const std::int32_t component = arrays_.find(side.a, side.b)->componentNumber();
  triangles_.push_back({{side.b, side.a, apex}, component});
  put(triangles_.back());
}

void
GrowingMesh::addSeed(const std::array<std::int32_t, 3>& corners)
{
  const auto [a, b, c] = corners;
  const bool turned = facing_.shownArea(tree_, corners) < 0;
  triangles_.push_back({{a, turned ? c : b, turned ? b : c}, parity_.addComponent()});
  put(triangles_.back());
}

std::int32_t
GrowingMesh::endOfFan(std::int32_t at, const Side& side)
{
  std::int32_t previous = side.a == at ? side.b : side.a;
  std::int32_t next = oppositeOf(side);
  for (;;) {
    const Edge& edge = *arrays_.find(at, next);
    if (edge.isOpen())
      return next;
    const std::int32_t beyond = edge.opposites ^ previous;
    previous = next;
    next = beyond;
  }
}

std::vector<Side>
GrowingMesh::openSides(std::int32_t begin, std::int32_t end)
{
  std::vector<Side> sides;
  for (std::int32_t low = begin; low < end; ++low)
    if (vertex(low).open_edges > 0)
      arrays_.forEachEdgeAt(low, [&](const Edge& edge) {
        if (edge.isOpen())
          sides.push_back(edge.ascending ? Side{low, edge.high} : Side{edge.high, low});
      });
  return sides;
}

} // namespace pcl::acmap::ACMAP_DEWALL
