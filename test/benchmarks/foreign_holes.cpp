#include "foreign_holes.h"

#include "face_edges.h"

#include <algorithm>
#include <set>

namespace pcl::acmap::bench {

namespace {

std::vector<test::Edge>
boundaryEdges(const test::Triangles& faces)
{
  std::vector<test::Edge> result;
  for (const auto& [edge, uses] : test::edgesOf(faces))
    if (uses.size() == 1)
      result.push_back(edge);
  return result;
}

} // namespace

std::size_t
countForeignHoles(const test::Points& points,
                  const test::Triangles& mesh,
                  const test::Triangles& model,
                  double reach)
{
  std::set<std::int32_t> rim;
  for (const auto& [a, b] : boundaryEdges(model))
    rim.insert({a, b});
  const auto isNearRim = [&](std::int32_t i) {
    return std::any_of(rim.begin(), rim.end(), [&](std::int32_t j) {
      return (points[i] - points[j]).norm() <= reach;
    });
  };
  test::FaceSets loops(points.size());
  std::set<std::int32_t> corners;
  for (const auto& [a, b] : boundaryEdges(mesh)) {
    loops.unite(a, b);
    corners.insert({a, b});
  }
  std::set<std::size_t> all, own;
  for (const std::int32_t corner : corners) {
    all.insert(loops.find(corner));
    if (isNearRim(corner))
      own.insert(loops.find(corner));
  }
  return all.size() - own.size();
}

} // namespace pcl::acmap::bench
