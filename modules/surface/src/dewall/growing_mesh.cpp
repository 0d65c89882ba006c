#include "growing_mesh.h"

#include "poll_pace.h"
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
    const Eigen::Vector3f& normal = arrays_.normal(end);
    const float along = normal.dot(area) * (root.flipped != own.flipped ? -1.0f : 1.0f);
    if (root.component == own.component &&
        along < static_cast<float>(cos_gentle_turn) * normal.norm() * plumpness)
      return true;
  }
  return false;
}

GrowingMesh::Demands
GrowingMesh::demands(const Proposal& proposal)
{
  const auto& [side, apex, base, at_a, at_b] = proposal;
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
GrowingMesh::bridge(const Proposal& proposal)
{
  const Demands all = demands(proposal);
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
GrowingMesh::steepestCosine(const Proposal& proposal) const
{
  const auto& [side, apex, base, at_a, at_b] = proposal;
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
GrowingMesh::judge(const Proposal& proposal)
{
  const auto& [side, apex, base, at_a, at_b] = proposal;
  if ((at_a && !at_a->isOpen()) || (at_b && !at_b->isOpen()))
    return Verdict::Blocked;
  // At most one pinch per vertex is permitted, because most are removed later.
  if (!at_a && !at_b && isUsed(apex))
    return vertex(apex).open_edges == 2 ? Verdict::Pinches : Verdict::Blocked;
  const double cosine = steepestCosine(proposal);
  if (cosine <= cos_largest_turn)
    return Verdict::Blocked;
  if ((at_a || at_b) && !isOrientable(demands(proposal))) {
    ++refused_moebius_;
    return Verdict::Blocked;
  }
  return cosine < cos_gentle_turn || isOdd(side, apex, base->componentNumber())
             ? Verdict::Doubtful
             : Verdict::Fits;
}

void
GrowingMesh::attach(const Side& side,
                    Edge* edge,
                    std::int32_t opposite,
                    std::int32_t component)
{
  const auto [from, to] = side;
  const bool ascending = from < to;
  if (!edge) {
    edge = &arrays_.addEdge(from, to, memory_of_edges_);
    *edge = {opposite, 0, ascending, 0};
    edge->setComponent(component);
    arrays_.countOpenEdge(from, to, 1);
  }
  else if (edge->isOpen()) {
    const std::int32_t first = edge->componentNumber();
    const bool flipped = bool(edge->ascending) == ascending;
    if (parity_.unite(first, component, flipped))
      joints_.push_back({first, component, flipped});
    edge->opposites ^= opposite;
    arrays_.countOpenEdge(from, to, -1);
  }
  ++edge->triangles;
}

void
GrowingMesh::detachEdge(const Side& side, std::int32_t opposite, std::int32_t component)
{
  Edge& edge = *arrays_.find(side.a, side.b);
  arrays_.countOpenEdge(side.a, side.b, edge.isOpen() ? -1 : 1);
  edge.opposites ^= opposite;
  if (--edge.triangles == 0)
    arrays_.removeEdge(side.a, side.b, memory_of_edges_);
  else if (edge.componentNumber() == component &&
           bool(edge.ascending) == (side.a < side.b) &&
           !(arrays_.is(side.a, VertexFlag::mixed) &&
             arrays_.is(side.b, VertexFlag::mixed)))
    edge.ascending = !edge.ascending; // the other triangle is of the same component
}

void
GrowingMesh::reassignSeams(const GrownTriangles& triangles)
{
  constexpr std::uint8_t both = VertexFlag::mixed | VertexFlag::lost;
  PollPace pace;
  for (const GrownTriangle& triangle : triangles) {
    pace();
    std::array<bool, 3> is_doubtful;
    for (std::size_t i = 0; i < 3; ++i)
      is_doubtful[i] = (arrays_.flagsOf(triangle.corners[i]) & both) == both;
    if (is_doubtful[0] + is_doubtful[1] + is_doubtful[2] < 2)
      continue;
    const std::array<Side, 3> sides = sidesOf(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_doubtful[i] || !is_doubtful[(i + 1) % 3])
        continue;
      Edge& edge = *arrays_.find(sides[i].a, sides[i].b);
      if (edge.isOpen()) {
        edge.setComponent(triangle.component);
        edge.ascending = sides[i].a < sides[i].b;
      }
    }
  }
}

void
GrowingMesh::sweep(const std::vector<GrownTriangles*>& lists)
{
  oneapi::tbb::parallel_for(std::size_t{0}, lists.size(), [&](std::size_t l) {
    GrownTriangles& list = *lists[l];
    PollPace pace;
    list.erase(std::remove_if(list.begin(),
                              list.end(),
                              [&](const GrownTriangle& t) {
                                pace();
                                return t.isTakenOut();
                              }),
               list.end());
    reassignSeams(list);
  });
}

void
GrowingMesh::put(const GrownTriangle& triangle, const std::array<Edge*, 3>& edges)
{
  const std::array<Side, 3> sides = sidesOf(triangle);
  for (std::size_t i = 0; i < 3; ++i)
    attach(sides[i], edges[i], triangle.corners[(i + 2) % 3], triangle.component);
  const Eigen::Vector3f area = areaVector(triangle.corners);
  for (const std::int32_t corner : triangle.corners)
    addToVertex(corner, triangle.component, area);
}

void
GrowingMesh::addToVertex(std::int32_t corner,
                         std::int32_t component,
                         const Eigen::Vector3f& area)
{
  Vertex& v = vertex(corner);
  if (v.open_edges > 2)
    arrays_.set(corner, VertexFlag::pinched);
  if (v.triangles > 0 && v.component != component)
    arrays_.set(corner, VertexFlag::mixed);
  if (is_of_wall_)
    arrays_.set(corner, VertexFlag::of_wall);
  if (v.triangles == 0) {
    v.component = component;
    arrays_.normal(corner).setZero();
    arrays_.noteUse(corner, true);
  }
  if (v.triangles < 0xffff)
    ++v.triangles;
  const ParityUnion::Root own = parity_.find(component);
  const ParityUnion::Root root = parity_.find(v.component);
  if (root.component == own.component)
    arrays_.normal(corner) +=
        root.flipped != own.flipped ? Eigen::Vector3f(-area) : area;
  if (v.open_edges == 0)
    arrays_.noteSaturation(corner, true);
}

void
GrowingMesh::takeOut(GrownTriangle& triangle)
{
  const std::array<Side, 3> sides = sidesOf(triangle);
  for (std::size_t i = 0; i < 3; ++i)
    detachEdge(sides[i], triangle.corners[(i + 2) % 3], triangle.component);
  for (const std::int32_t corner : triangle.corners) {
    Vertex& v = vertex(corner);
    arrays_.set(corner, VertexFlag::lost);
    arrays_.set(corner, VertexFlag::pinched); // its fan may be split by the removal
    if (--v.triangles == 0)
      arrays_.noteUse(corner, false);
    arrays_.noteSaturation(corner, v.triangles > 0 && v.open_edges == 0);
  }
  triangle.component = -1;
}

void
GrowingMesh::add(const Proposal& proposal)
{
  const auto& [side, apex, base, at_a, at_b] = proposal;
  triangles_.push_back({{side.b, side.a, apex}, base->componentNumber()});
  put(triangles_.back(), {base, at_a, at_b});
}

void
GrowingMesh::addSeed(const std::array<std::int32_t, 3>& corners)
{
  const auto [a, b, c] = corners;
  const bool turned = facing_.shownArea(tree_, corners) < 0;
  triangles_.push_back({{a, turned ? c : b, turned ? b : c}, parity_.addComponent()});
  put(triangles_.back(), {}); // no edge ends at an unused point
}

std::int32_t
GrowingMesh::endOfFan(std::int32_t at, const Side& side)
{
  std::int32_t previous = side.a == at ? side.b : side.a;
  const Vertex& v = vertex(at);
  if (v.open_edges == 2)
    return v.open_ends ^ previous;
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
      arrays_.forEachEdgeAt(low, [&](const Edge& edge, std::int32_t high) {
        if (edge.isOpen())
          sides.push_back(edge.ascending ? Side{low, high} : Side{high, low});
      });
  return sides;
}

} // namespace pcl::acmap::ACMAP_DEWALL
