#include "clouds.h"
#include "mesh_checker.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

/** Four corners of a square, its centre, and a point above the centre. */
const Points square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {1, 1, 1}};

const Triangles fan{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

Triangles
fanWith(std::initializer_list<Triangle> more)
{
  Triangles faces = fan;
  faces.insert(faces.end(), more);
  return faces;
}

TEST(MeshChecker, acceptsASoundMesh)
{
  MeshDemands demands;
  demands.edge_allowed = noLongerThan(square, 2);
  demands.empty_spheres = true;
  EXPECT_EQ(checkMesh(square, fan, demands).total(), 0U);
  EXPECT_EQ(checkMesh(square, {}, demands).total(), 0U);
}

TEST(MeshChecker, countsWhatAMeshConsistsOf)
{
  const MeshCounts counts = countMesh(square, fan);
  EXPECT_EQ(counts.faces, 4U);
  EXPECT_EQ(counts.used_points, 5U);
  EXPECT_EQ(counts.edges, 8U);
  EXPECT_EQ(counts.boundary_edges, 4U);
  EXPECT_EQ(counts.components, 1U);
  EXPECT_EQ(counts.boundary_loops, 1U);

  const MeshCounts apart = countMesh(square, {fan[0], fan[2]});
  EXPECT_EQ(apart.components, 2U);
  EXPECT_EQ(apart.boundary_edges, 6U);
}

TEST(MeshChecker, findsInvalidIndices)
{
  Points points = square;
  points[5].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
      checkMesh(points, fanWith({{0, 1, 6}, {0, -1, 2}, {0, 1, 5}})).invalid_faces, 3U);
}

TEST(MeshChecker, findsDegenerateFaces)
{
  EXPECT_EQ(checkMesh(square, fanWith({{0, 5, 5}, {0, 4, 2}})).degenerate_faces, 2U);
}

TEST(MeshChecker, findsDuplicatesWhateverTheirCornersOrder)
{
  EXPECT_EQ(checkMesh(square, fanWith({{4, 0, 1}, {1, 0, 4}})).duplicate_faces, 2U);
}

TEST(MeshChecker, findsCrowdedEdges)
{
  const MeshFaults faults = checkMesh(square, fanWith({{0, 4, 5}}));
  EXPECT_EQ(faults.crowded_edges, 1U);
  EXPECT_EQ(faults.torn_vertices, 2U);
}

TEST(MeshChecker, findsTornVertices)
{
  EXPECT_EQ(checkMesh(square, {fan[0], fan[2]}).torn_vertices, 1U);
  EXPECT_EQ(checkMesh(square, {fan[0], fan[1], fan[2]}).torn_vertices, 0U);
}

TEST(MeshChecker, findsInconsistentOrientation)
{
  Triangles turned = fan;
  std::swap(turned[1][0], turned[1][1]);
  EXPECT_EQ(checkMesh(square, turned).inconsistent_edges, 2U);
}

TEST(MeshChecker, findsForbiddenEdges)
{
  MeshDemands demands;
  demands.edge_allowed = noLongerThan(square, 1.9);
  EXPECT_EQ(checkMesh(square, fan, demands).forbidden_edges, 4U);
}

TEST(MeshChecker, findsOccupiedSpheres)
{
  MeshDemands demands;
  demands.empty_spheres = true;
  EXPECT_EQ(checkMesh(square, {{0, 1, 2}}, demands).occupied_spheres, 1U);
  const Points near{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2 - 1e-5, 2 - 1e-5, 0}};
  EXPECT_EQ(checkMesh(near, {{0, 1, 2}}, demands).occupied_spheres, 1U);
  const Points cocircular{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2 - 1e-9, 2 - 1e-9, 0}};
  EXPECT_EQ(checkMesh(cocircular, {{0, 1, 2}}, demands).occupied_spheres, 0U);
}

TEST(MeshChecker, treeFindsWhatBruteForceFinds)
{
  const Points points = toPoints(makeRandomBox(500, 7));
  const ReferenceTree tree(points);
  const Points queries = toPoints(makeRandomBox(200, 8));
  std::size_t occupied = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double radius = 0.001 * static_cast<double>(i);
    double minimum = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& point : points)
      minimum = std::min(minimum, (point - queries[i]).squaredNorm());
    EXPECT_EQ(tree.findWithin(queries[i], radius) >= 0, minimum < radius * radius);
    EXPECT_EQ(tree.nearest(queries[i], 1).front().first, minimum);
    const auto inside = std::count_if(points.begin(), points.end(), [&](const auto& p) {
      return (p - queries[i]).squaredNorm() <= radius * radius;
    });
    EXPECT_EQ(tree.within(queries[i], radius).size(), static_cast<std::size_t>(inside));
    occupied += minimum < radius * radius;
  }
  EXPECT_GT(occupied, 20U);
  EXPECT_LT(occupied, 180U);
}

TEST(MeshChecker, circumsphereHoldsItsCornersInItsPlane)
{
  const Points p = toPoints(makeRandomBox(300, 3));
  for (std::size_t i = 0; i + 2 < p.size(); i += 3) {
    const SmallestSphere sphere = smallestCircumsphere(p[i], p[i + 1], p[i + 2]);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR((p[i + k] - sphere.center).norm() / sphere.radius, 1, 1e-9);
    const Eigen::Vector3d normal =
        (p[i + 1] - p[i]).cross(p[i + 2] - p[i]).normalized();
    EXPECT_NEAR(normal.dot(sphere.center - p[i]) / sphere.radius, 0, 1e-9);
  }
  EXPECT_TRUE(std::isinf(smallestCircumsphere({0, 0, 0}, {1, 0, 0}, {2, 0, 0}).radius));
}

TEST(MeshChecker, spacingIgnoresDoubledAndInvalidPoints)
{
  const Cloud grid = makeGrid(8, 8, 0.5, ExactPlane::Level);
  EXPECT_DOUBLE_EQ(medianSpacing(toPoints(grid)), 0.5);
  EXPECT_DOUBLE_EQ(medianSpacing(toPoints(lacedWithNan(doubled(grid), 5))), 0.5);
  EXPECT_EQ(medianSpacing(toPoints(makeCoincident(9))), 0);
}

TEST(MeshChecker, readsPolygonsOfPcl)
{
  std::vector<Vertices> polygons(2);
  polygons[0].vertices = {0, 1, 2, 3};
  polygons[1].vertices = {4, 5, 0};
  EXPECT_EQ(toTriangles(polygons), (Triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 0}}));
}

} // namespace
} // namespace pcl::acmap::test
