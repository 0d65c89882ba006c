#include "growing_mesh.h"

#include "predicates.h"

namespace pcl::acmap::dewall {

std::int32_t
GrowingMesh::oppositeOf(const Side& side)
{
  const Edge* edge = edges_.find(side.a, side.b);
  return edge && edge->isOpen() ? edge->opposite : -1;
}

double
GrowingMesh::cosineOfTurnAt(std::int32_t a,
                            std::int32_t b,
                            const Edge& edge,
                            std::int32_t corner) const
{
  return cosineOfTurn(tree_.position(a),
                      tree_.position(b),
                      tree_.position(edge.opposite),
                      tree_.position(corner));
}

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
GrowingMesh::isOdd(const Side& side, std::int32_t apex)
{
  const Eigen::Vector3f area = areaVector({side.b, side.a, apex});
  const float plumpness = area.norm();
  if (plumpness < static_cast<float>(least_plumpness))
    return true;
  const ParityUnion::Root own = parity_.find(edges_.find(side.a, side.b)->component);
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
                     const Edge* at_a,
                     const Edge* at_b)
{
  Demands all;
  // Neighbours agree when they run through their common edge in opposite directions.
  const auto demand = [&](const Edge* edge, bool ascending) {
    if (!edge || !edge->isOpen())
      return;
    const ParityUnion::Root root = parity_.find(edge->component);
    all.of[all.count++] = {root.component,
                           root.flipped != (edge->ascending == ascending)};
  };
  demand(edges_.find(side.a, side.b), side.b < side.a);
  demand(at_a, side.a < apex);
  demand(at_b, apex < side.b);
  return all;
}

GrowingMesh::Bridge
GrowingMesh::bridge(const Side& side, std::int32_t apex)
{
  const Demands all =
      demands(side, apex, edges_.find(side.a, apex), edges_.find(side.b, apex));
  for (std::size_t i = 1; i < all.count; ++i)
    if (all.of[i].root != all.of[0].root)
      return {std::min(all.of[i].root, all.of[0].root),
              std::max(all.of[i].root, all.of[0].root),
              all.of[i].flipped != all.of[0].flipped};
  return {};
}

bool
GrowingMesh::isOrientable(const Side& side,
                          std::int32_t apex,
                          const Edge* at_a,
                          const Edge* at_b)
{
  const Demands all = demands(side, apex, at_a, at_b);
  if (facing_.isKnown()) // all components face it already: none may be turned over
    return std::none_of(all.of.begin(),
                        all.of.begin() + static_cast<std::ptrdiff_t>(all.count),
                        [](const Demands::Demand& demand) { return demand.flipped; });
  for (std::size_t i = 1; i < all.count; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (all.of[i].root == all.of[j].root && all.of[i].flipped != all.of[j].flipped)
        return false;
  return true;
}

bool
GrowingMesh::isContrary(const Side& side, std::int32_t apex)
{
  return facing_.shownArea(tree_, {side.b, side.a, apex}) < 0;
}

const Edge*
GrowingMesh::findUsed(std::int32_t a, std::int32_t b)
{
  const Edge* edge = edges_.find(a, b);
  return edge && edge->triangles > 0 ? edge : nullptr;
}

double
GrowingMesh::steepestCosine(const Side& side, std::int32_t apex)
{
  double least = cosineOfTurnAt(side.a, side.b, *edges_.find(side.a, side.b), apex);
  if (const Edge* at_a = findUsed(side.a, apex))
    least = std::min(least, cosineOfTurnAt(side.a, apex, *at_a, side.b));
  if (const Edge* at_b = findUsed(side.b, apex))
    least = std::min(least, cosineOfTurnAt(side.b, apex, *at_b, side.a));
  return least;
}

GrowingMesh::Verdict
GrowingMesh::judge(const Side& side, std::int32_t apex)
{
  const Edge* at_a = findUsed(side.a, apex);
  const Edge* at_b = findUsed(side.b, apex);
  if ((at_a && !at_a->isOpen()) || (at_b && !at_b->isOpen()))
    return Verdict::Blocked;
  if (!at_a && !at_b && isUsed(apex))
    return isSaturated(apex) ? Verdict::Blocked : Verdict::Pinches;
  const double cosine = steepestCosine(side, apex);
  if (cosine <= cos_largest_turn)
    return Verdict::Blocked;
  if ((at_a || at_b) && !isOrientable(side, apex, at_a, at_b)) {
    ++refused_moebius_;
    return Verdict::Blocked;
  }
  return cosine < cos_gentle_turn || isOdd(side, apex) ? Verdict::Doubtful
                                                       : Verdict::Fits;
}

void
GrowingMesh::attach(std::int32_t from,
                    std::int32_t to,
                    std::int32_t opposite,
                    std::int32_t component)
{
  Edge* found = edges_.find(from, to);
  Edge& edge = found ? *found : edges_.add(from, to);
  const bool ascending = from < to;
  if (edge.triangles == 0) {
    edge.opposite = opposite;
    edge.component = component;
    edge.ascending = ascending;
    ++vertex(from).open_edges;
    ++vertex(to).open_edges;
  }
  else if (edge.isOpen()) {
    parity_.unite(edge.component, component, edge.ascending == ascending);
    --vertex(from).open_edges;
    --vertex(to).open_edges;
  }
  ++edge.triangles;
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
    if (!v.used)
      v.component = triangle.component;
    const ParityUnion::Root root = parity_.find(v.component);
    if (root.component == own.component)
      v.normal += root.flipped != own.flipped ? Eigen::Vector3f(-area) : area;
    v.used = true;
  }
}

void
GrowingMesh::add(const Side& side, std::int32_t apex, std::uint8_t depth)
{
  const std::int32_t component = edges_.find(side.a, side.b)->component;
  triangles_.push_back({{side.b, side.a, apex}, component, depth});
  put(triangles_.back());
}

void
GrowingMesh::addSeed(const std::array<std::int32_t, 3>& corners, std::uint8_t depth)
{
  const auto [a, b, c] = corners;
  const bool turned = facing_.shownArea(tree_, corners) < 0;
  triangles_.push_back(
      {{a, turned ? c : b, turned ? b : c}, parity_.addComponent(), depth});
  put(triangles_.back());
}

std::vector<Side>
GrowingMesh::openSides()
{
  std::vector<Side> sides;
  for (std::int32_t low = 0; low < tree_.size(); ++low)
    if (vertex(low).open_edges > 0)
      edges_.forEachAt(low, [&](const Edge& edge) {
        if (edge.isOpen())
          sides.push_back(edge.ascending ? Side{low, edge.high} : Side{edge.high, low});
      });
  return sides;
}

} // namespace pcl::acmap::dewall
