#include "voting_meshes.h"

#include <pcl/core/random.h>

#include <cmath>
#include <map>
#include <utility>

namespace pcl::acmap::test {
namespace {

using Triangle = TriangleMesh::Triangle;

} // namespace

VotingMesh
makeSheetMesh(int columns, int rows, double spacing, const Place& place)
{
  VotingMesh mesh;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      mesh.cloud.push_back(toPoint(place((column - (columns - 1) / 2.0) * spacing,
                                         (row - (rows - 1) / 2.0) * spacing)));
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const std::int32_t a = row * columns + column;
      const std::int32_t b = a + columns;
      mesh.faces.triangles.push_back({a, a + 1, b + 1});
      mesh.faces.triangles.push_back({a, b + 1, b});
    }
  return mesh;
}

VotingMesh
makePlaneMesh(int columns, int rows, double spacing)
{
  return makeSheetMesh(columns, rows, spacing, [](double u, double v) {
    return Eigen::Vector3d(u, v, 0);
  });
}

VotingMesh
makeRoofMesh(double angle)
{
  return makeSheetMesh(41, 21, 1, [angle](double u, double v) {
    return Eigen::Vector3d(
        u * std::sin(angle / 2), v, -std::abs(u) * std::cos(angle / 2));
  });
}

VotingMesh
makeHalfCylinderMesh(int rows, double radius)
{
  constexpr int around = 33;
  const double spacing = M_PI * radius / (around - 1);
  return makeSheetMesh(around, rows, spacing, [radius](double u, double v) {
    return Eigen::Vector3d(
        radius * std::sin(u / radius), v, radius * std::cos(u / radius));
  });
}

VotingMesh
makeRoughMesh(int side, double height, std::uint64_t seed)
{
  Random random(seed);
  return makeSheetMesh(side, side, 1, [&](double u, double v) {
    return Eigen::Vector3d(u + random.uniform(-0.2, 0.2),
                           v + random.uniform(-0.2, 0.2),
                           random.uniform(0, height));
  });
}

VotingMesh
turnedOver(VotingMesh mesh)
{
  for (Triangle& triangle : mesh.faces.triangles)
    std::swap(triangle[1], triangle[2]);
  return mesh;
}

std::vector<bool>
innerVertices(const VotingMesh& mesh)
{
  std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
  for (const Triangle& triangle : mesh.faces.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[std::minmax(triangle[k], triangle[(k + 1) % 3])];
  std::vector<bool> is_inner(mesh.cloud.size(), true);
  for (const auto& [edge, count] : edges)
    if (count == 1)
      is_inner[static_cast<std::size_t>(edge.first)] =
          is_inner[static_cast<std::size_t>(edge.second)] = false;
  return is_inner;
}

} // namespace pcl::acmap::test
