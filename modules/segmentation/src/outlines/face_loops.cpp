#include "outlines/face_loops.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::outlines {
namespace {

struct RimEdge {
  std::int32_t from, to;
  bool is_taken = false;
};

/** Edges with a triangle on their left only, sorted by their first vertex. */
std::vector<std::pair<std::int32_t, std::int32_t>>
rimEdges(const TriangleMesh::Triangles& triangles)
{
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  for (const TriangleMesh::Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      edges.emplace_back(t[k], t[(k + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  std::vector<std::pair<std::int32_t, std::int32_t>> rim;
  for (const auto& [from, to] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::make_pair(to, from)))
      rim.emplace_back(from, to);
  return rim;
}

/** Returns the edge that continues a loop after another edge: the first one clockwise
 * from the reversed edge, which may be the first edge of the loop. */
RimEdge*
nextEdge(std::vector<RimEdge>& rim,
         const RimEdge& first,
         const RimEdge& edge,
         const PlaceOfVertex& place)
{
  auto candidate = std::lower_bound(
      rim.begin(), rim.end(), edge.to, [](const RimEdge& e, std::int32_t vertex) {
        return e.from < vertex;
      });
  if (candidate == rim.end() || candidate->from != edge.to)
    return nullptr;
  const auto after = candidate + 1;
  if (after == rim.end() || after->from != edge.to)
    return candidate->is_taken && &*candidate != &first ? nullptr : &*candidate;
  const Eigen::Vector2d back = place(edge.from) - place(edge.to);
  RimEdge* best = nullptr;
  double minimum = 0;
  for (; candidate != rim.end() && candidate->from == edge.to; ++candidate) {
    if (candidate->is_taken && &*candidate != &first)
      continue;
    const Eigen::Vector2d way = place(candidate->to) - place(edge.to);
    double clockwise =
        std::atan2(way.x() * back.y() - way.y() * back.x(), way.dot(back));
    if (clockwise <= 0)
      clockwise += 2 * M_PI;
    if (!best || clockwise < minimum) {
      minimum = clockwise;
      best = &*candidate;
    }
  }
  return best;
}

} // namespace

std::vector<std::vector<std::int32_t>>
faceLoops(const TriangleMesh::Triangles& triangles,
          const std::vector<Eigen::Vector2d>& places)
{
  return edgeLoops(rimEdges(triangles), [&](std::int32_t vertex) {
    return places[static_cast<std::size_t>(vertex)];
  });
}

std::vector<std::vector<std::int32_t>>
edgeLoops(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
          const PlaceOfVertex& place)
{
  std::vector<RimEdge> rim;
  for (const auto& [from, to] : edges)
    rim.push_back({from, to});
  std::vector<std::vector<std::int32_t>> loops;
  for (RimEdge& first : rim) {
    std::vector<std::int32_t> loop;
    for (RimEdge* edge = &first; edge && !edge->is_taken;
         edge = nextEdge(rim, first, *edge, place)) {
      edge->is_taken = true;
      loop.push_back(edge->from);
    }
    if (loop.size() >= 3)
      loops.push_back(std::move(loop));
  }
  return loops;
}

} // namespace pcl::acmap::outlines
