#include "cell_polygons.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap::test {

namespace {

using Place = std::pair<int, int>;
using Edges = std::multimap<Place, Place>; // from corner to corner

/** Removes one edge-connected component from the cells. */
Cells
takePart(Cells& cells)
{
  Cells part;
  std::vector<Place> waiting = {*cells.begin()};
  while (!waiting.empty()) {
    const Place cell = waiting.back();
    waiting.pop_back();
    if (cells.erase(cell) == 0)
      continue;
    part.insert(cell);
    const auto [x, y] = cell;
    waiting.insert(waiting.end(), {{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}});
  }
  return part;
}

/** The boundary edges of a component; its cells are to their left. */
Edges
rimOf(const Cells& part)
{
  Edges edges;
  for (const auto& [x, y] : part) {
    if (!part.count({x, y - 1}))
      edges.insert({{x, y}, {x + 1, y}});
    if (!part.count({x + 1, y}))
      edges.insert({{x + 1, y}, {x + 1, y + 1}});
    if (!part.count({x, y + 1}))
      edges.insert({{x + 1, y + 1}, {x, y + 1}});
    if (!part.count({x - 1, y}))
      edges.insert({{x, y + 1}, {x, y}});
  }
  return edges;
}

int
turnOf(const Place& a, const Place& b, const Place& c)
{
  return (b.first - a.first) * (c.second - b.second) -
         (b.second - a.second) * (c.first - b.first);
}

/** Removes a loop from the edges. If there are two possible continuations, it turns
 * left, which follows the same cell, or right, which continues along the touching
 * cell. */
std::vector<Place>
takeLoop(Edges& edges, bool right)
{
  std::vector<Place> loop = {edges.begin()->first};
  Place at = edges.begin()->second;
  edges.erase(edges.begin());
  const Place second = at;
  for (;;) {
    const auto [first, last] = edges.equal_range(at);
    // At the start, continues only if the loop would not be closed by the preferred
    // turn.
    auto best = edges.end();
    for (auto edge = first; edge != last; ++edge)
      if (best == edges.end() || (turnOf(loop.back(), at, edge->second) <
                                  turnOf(loop.back(), at, best->second)) == right)
        best = edge;
    const bool closes = at == loop.front();
    if (best == edges.end() ||
        (closes && (turnOf(loop.back(), at, second) <
                    turnOf(loop.back(), at, best->second)) == right))
      return loop;
    loop.push_back(at);
    at = best->second;
    edges.erase(best);
  }
}

double
areaOf(const std::vector<Place>& loop)
{
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Place& a = loop[i];
    const Place& b = loop[(i + 1) % loop.size()];
    area += 0.5 * (a.first * b.second - a.second * b.first);
  }
  return area;
}

PlanePolygon
polygonOf(const Cells& part, bool pinched)
{
  PlanePolygon polygon;
  for (Edges edges = rimOf(part); !edges.empty();) {
    const std::vector<Place> loop = takeLoop(edges, pinched);
    std::vector<Eigen::Vector3f> points;
    for (const auto& [x, y] : loop)
      points.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0F);
    if (areaOf(loop) > 0)
      polygon.outer = points;
    else
      polygon.holes.push_back(points);
  }
  return polygon;
}

} // namespace

CellRegion::CellRegion(std::uint64_t seed, int side)
{
  Random random(seed);
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      if (random.uniform() < 0.65)
        cells_.insert({x, y});
}

std::vector<std::pair<PlanePolygon, Cells>>
CellRegion::polygons(bool pinched) const
{
  std::vector<std::pair<PlanePolygon, Cells>> polygons;
  for (Cells cells = cells_; !cells.empty();) {
    const Cells part = takePart(cells);
    polygons.emplace_back(polygonOf(part, pinched), part);
  }
  return polygons;
}

int
wronglyCovered(const PlanePolygon& polygon,
               const Cells& cells,
               const TriangleMesh::Triangles& triangles)
{
  std::vector<Eigen::Vector2d> points;
  const auto append = [&](const std::vector<Eigen::Vector3f>& loop) {
    for (const Eigen::Vector3f& p : loop)
      points.emplace_back(p.x(), p.y());
  };
  append(polygon.outer);
  std::for_each(polygon.holes.begin(), polygon.holes.end(), append);
  int wrong = 0;
  for (int i = -2; i < 28; ++i)
    for (int k = -2; k < 28; ++k) {
      // not on a line through lattice points
      const Eigen::Vector2d p(0.5 * i + 0.2371, 0.5 * k + 0.1893);
      int cover = 0;
      for (const TriangleMesh::Triangle& triangle : triangles) {
        bool inside = true;
        for (std::size_t side = 0; side < 3; ++side) {
          const Eigen::Vector2d& a = points[static_cast<std::size_t>(triangle[side])];
          const Eigen::Vector2d& b =
              points[static_cast<std::size_t>(triangle[(side + 1) % 3])];
          inside = inside && (b.x() - a.x()) * (p.y() - a.y()) >
                                 (b.y() - a.y()) * (p.x() - a.x());
        }
        cover += inside;
      }
      const Place cell(static_cast<int>(std::floor(p.x())),
                       static_cast<int>(std::floor(p.y())));
      wrong += cover != static_cast<int>(cells.count(cell));
    }
  return wrong;
}

} // namespace pcl::acmap::test
