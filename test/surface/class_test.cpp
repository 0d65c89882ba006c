#include "coverage.h"
#include "dewall_runs.h"

#include <pcl/conversions.h>
#include <pcl/surface/impl/dewall_kernel.h>

#include <algorithm>
#include <numeric>

#ifdef ACMAP_FEW_POINT_TYPES
#include <pcl/surface/impl/dewall_triangulation.hpp>
#endif

namespace pcl::acmap::test {
namespace {

Eigen::Vector3d
normalOf(const Points& points, const Triangle& t)
{
  return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
}

/** Fraction of faces whose front is towards a point. */
double
shareFacing(const DeWallResult& result, const Eigen::Vector3d& place)
{
  const Triangles& mesh = result.mesh.triangles;
  const auto facing = std::count_if(mesh.begin(), mesh.end(), [&](const Triangle& t) {
    return normalOf(result.points, t).dot(place - result.points[t[0]]) > 0;
  });
  return static_cast<double>(facing) / static_cast<double>(mesh.size());
}

TEST(DeWallClass, facesLookTowardsTheSensor)
{
  Cloud cap = makeSphereCap({40, 40, 0.02, 0.25, 0, 1}, 0.5).cloud;
  for (const float height : {0.0F, 3.0F}) {
    cap.sensor_origin_ = Eigen::Vector4f(0, 0, height, 1);
    for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense})
      EXPECT_GT(shareFacing(triangulate(cap, {rule, 0.06}), {0, 0, height}), 0.995);
  }
  Cloud room = makeRoom(0.1, 0.02, 1);
  EXPECT_GT(shareFacing(triangulate(room, {DeWallRule::Guarded, 0.25}), {0, 0, 0}),
            0.99);
}

TEST(DeWallClass, eachComponentLooksTowardsTheSensor)
{
  Cloud cloud = makeParallelSheets({20, 20, 0.02, 0.25, 0, 1}, 1);
  cloud.sensor_origin_ = Eigen::Vector4f(0, 0, 0.5F, 1);
  const DeWallResult result = triangulate(cloud, {DeWallRule::Guarded, 0.06});
  EXPECT_EQ(result.report.components, 2U);
  EXPECT_EQ(shareFacing(result, {0, 0, 0.5}), 1);
}

TEST(DeWallClass, wallOfTheFirstPlaneIsCutByOnePlane)
{
  const Cloud cloud = makeJitteredPlane({40, 40, 1, 0.25, 0.05, 1}).cloud;
  const DeWallResult result =
      triangulateInLeaves(cloud, {DeWallRule::Guarded, 3, 1, true}, 50);
  const auto& depth = result.mesh.wall_depth;
  ASSERT_EQ(depth.size(), result.mesh.triangles.size());
  std::size_t first_wall = 0;
  Eigen::Vector3d greatest_low = Eigen::Vector3d::Constant(-1e9);
  Eigen::Vector3d min_high = Eigen::Vector3d::Constant(1e9);
  for (std::size_t i = 0; i < depth.size(); ++i)
    if (depth[i] == 0) {
      const Triangle& t = result.mesh.triangles[i];
      const auto& p = result.points;
      ++first_wall;
      greatest_low = greatest_low.cwiseMax(p[t[0]].cwiseMin(p[t[1]]).cwiseMin(p[t[2]]));
      min_high = min_high.cwiseMin(p[t[0]].cwiseMax(p[t[1]]).cwiseMax(p[t[2]]));
    }
  EXPECT_GT(first_wall, 40U);
  EXPECT_LT(first_wall, depth.size() / 10);
  EXPECT_TRUE((greatest_low.array() <= min_high.array()).any());
  const auto deepest =
      std::accumulate(depth.begin(), depth.end(), 0, [](int maximum, int d) {
        return d == TriangleMesh::no_wall ? maximum : std::max(maximum, d);
      });
  EXPECT_GE(deepest, 4);
  EXPECT_LE(deepest, 10);
}

TEST(DeWallClass, wallDepthIsAbsentUnlessAskedFor)
{
  const Cloud cloud = makeGrid(10, 10, 1, ExactPlane::Level);
  EXPECT_TRUE(triangulate(cloud, {DeWallRule::Guarded, 2}).mesh.wall_depth.empty());
}

TEST(DeWallClass, moebiusBandIsCutAndSaid)
{
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense}) {
    const DeWallRun run{rule, 0.25};
    const DeWallResult result = triangulate(makeMoebiusBand(60, 6, 1, 0.5, 7), run);
    EXPECT_TRUE(keepsGuarantees(result, run));
    EXPECT_GT(result.mesh.triangles.size(), 400U);
    EXPECT_GT(result.report.refused_moebius, 0U);
  }
}

TEST(DeWallClass, strictRuleIsThePapersAndNotManifold)
{
  const Cloud cloud = makeJitteredPlane({45, 45, 1, 0.25, 0.3, 1}).cloud;
  const DeWallResult strict = triangulate(cloud, {DeWallRule::Strict, 3});
  MeshDemands demands;
  demands.edge_allowed = noLongerThan(strict.points, 3);
  demands.empty_spheres = true;
  const MeshFaults faults = checkMesh(strict.points, strict.mesh.triangles, demands);
  EXPECT_GT(faults.crowded_edges, 50U);
  EXPECT_EQ(faults.forbidden_edges, 0U);
  EXPECT_EQ(faults.occupied_spheres, 0U);
  EXPECT_EQ(faults.duplicate_faces, 0U);
  EXPECT_EQ(faults.invalid_faces + faults.degenerate_faces, 0U);
}

TEST(DeWallClass, automaticLengthFollowsTheDensity)
{
  const SheetCloud sheet = makeGradedPlane({60, 90, 0.01, 0.2, 0.05, 3}, 10);
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense}) {
    const DeWallResult result = triangulate(sheet.cloud, {rule, 0});
    EXPECT_TRUE(keepsGuarantees(result, {rule, 0}));
    EXPECT_LT(measureCoverage(sheet, result.mesh.triangles).uncovered, 3);
    EXPECT_GT(result.report.largest_maximum_edge, 4 * result.report.min_maximum_edge);
    EXPECT_LT(result.report.largest_maximum_edge, 1);
    EXPECT_GT(result.report.min_maximum_edge, 0.01);
  }
}

TEST(DeWallClass, automaticLengthLeavesGapsOpen)
{
  Cloud cloud = makeJitteredPlane({30, 30, 0.01, 0.25, 0.05, 3}).cloud;
  Eigen::Isometry3d aside = Eigen::Isometry3d::Identity();
  aside.translation().x() = 0.4;
  cloud += moved(cloud, aside);
  const DeWallResult result = triangulate(cloud, {DeWallRule::Guarded, 0});
  EXPECT_EQ(result.report.components, 2U);
  EXPECT_LT(result.report.largest_maximum_edge, 0.08);
}

TEST(DeWallClass, indicesChooseThePoints)
{
  const Cloud cloud = makeJitteredPlane({30, 30, 1, 0.25, 0.05, 3}).cloud;
  Cloud chosen;
  const auto indices = std::make_shared<Indices>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud[i].x < 5) {
      indices->push_back(static_cast<index_t>(i));
      chosen.push_back(cloud[i]);
    }
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setMaximumEdgeLength(2.5);
  dewall.setInputCloud(cloud.makeShared());
  dewall.setIndices(indices);
  TriangleMesh mesh;
  dewall.reconstruct(mesh);
  EXPECT_EQ(dewall.getReport().points, chosen.size());
  const TriangleMesh alone = triangulate(chosen, {DeWallRule::Guarded, 2.5}).mesh;
  EXPECT_EQ(asSets(mesh.triangles), asSets(alone.triangles, *indices));
}

TEST(DeWallClass, indicesOutsideAreRefused)
{
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setInputCloud(makeRandomBox(10, 1).makeShared());
  TriangleMesh mesh;
  for (const index_t wrong : {10, -1}) {
    dewall.setIndices(std::make_shared<Indices>(Indices{0, 1, wrong}));
    EXPECT_THROW(dewall.reconstruct(mesh), InitFailedException);
  }
}

TEST(DeWallClass, cloudBeyondTheMemoryLimitIsRefused)
{
  const Cloud cloud = makeRandomBox(10000, 1);
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setInputCloud(cloud.makeShared());
  TriangleMesh mesh;
  mesh.triangles = {{1, 2, 3}};
  dewall.setMemoryLimit(1000000);
  EXPECT_EQ(dewall.getMemoryLimit(), 1000000U);
  EXPECT_THROW(dewall.reconstruct(mesh), MemoryLimitException);
  EXPECT_EQ(mesh.triangles.size(), 1U) << "a refusal leaves the output alone";
  dewall.setMemoryLimit(estimateDeWallMemory(cloud.size(), false, DeWallRule::Guarded));
  EXPECT_NO_THROW(dewall.reconstruct(mesh));
  EXPECT_GT(mesh.triangles.size(), 1U);
}

TEST(DeWallClass, organizedCloudWithHolesIsMeshedAroundThem)
{
  Cloud cloud = makeGrid(40, 30, 0.25, ExactPlane::Level);
  cloud.width = 40;
  cloud.height = 30;
  cloud.is_dense = false;
  for (std::size_t row = 10; row < 20; ++row)
    for (std::size_t column = 10; column < 20; ++column)
      cloud.at(column, row).x = std::numeric_limits<float>::quiet_NaN();
  const DeWallResult result = triangulate(cloud, {DeWallRule::Guarded, 0.5});
  EXPECT_TRUE(keepsGuarantees(result, {DeWallRule::Guarded, 0.5}));
  EXPECT_EQ(result.report.invalid_points, 100U);
  const std::size_t cut_corners = 4;
  EXPECT_EQ(result.mesh.triangles.size(), 2U * (39 * 29 - 11 * 11) + cut_corners);
  EXPECT_EQ(countMesh(result.points, result.mesh.triangles).boundary_loops, 2U);
}

TEST(DeWallClass, objectMeshesASmallerCloudAfterALarger)
{
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setMaximumEdgeLength(2.5);
  TriangleMesh mesh;
  for (const int size : {30, 10, 20}) {
    const Cloud cloud = makeJitteredPlane({size, size, 1, 0.25, 0.05, 3}).cloud;
    dewall.setInputCloud(cloud.makeShared());
    ASSERT_NO_THROW(dewall.reconstruct(mesh)) << size << " points a side";
    EXPECT_EQ(mesh.triangles,
              triangulate(cloud, {DeWallRule::Guarded, 2.5}).mesh.triangles);
  }
}

TEST(DeWallClass, polygonMeshHoldsTheCloudAndTheSameTriangles)
{
  const Cloud cloud = makeJitteredPlane({20, 20, 1, 0.25, 0.05, 3}).cloud;
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setInputCloud(cloud.makeShared());
  TriangleMesh mesh;
  PolygonMesh polygons;
  std::vector<Vertices> faces;
  dewall.reconstruct(mesh);
  static_cast<MeshConstruction<PointXYZ>&>(dewall).reconstruct(polygons);
  static_cast<MeshConstruction<PointXYZ>&>(dewall).reconstruct(faces);
  EXPECT_EQ(toTriangles(polygons.polygons), mesh.triangles);
  EXPECT_EQ(toTriangles(faces), mesh.triangles);
  Cloud written;
  fromPCLPointCloud2(polygons.cloud, written);
  EXPECT_EQ(toPoints(written), toPoints(cloud));
}

template <typename PointT>
TriangleMesh
triangulateAs(const Cloud& cloud)
{
  PointCloud<PointT> copy;
  for (const PointXYZ& point : cloud) {
    PointT other;
    other.getVector3fMap() = point.getVector3fMap();
    copy.push_back(other);
  }
  DeWallTriangulation<PointT> dewall;
  dewall.setInputCloud(copy.makeShared());
  TriangleMesh mesh;
  dewall.reconstruct(mesh);
  return mesh;
}

TEST(DeWallClass, otherPointTypesGiveTheSameMesh)
{
  const Cloud cloud = makeJitteredPlane({20, 20, 1, 0.25, 0.05, 3}).cloud;
  const Triangles triangles = triangulateAs<PointXYZ>(cloud).triangles;
  EXPECT_GT(triangles.size(), 600U);
  EXPECT_EQ(triangulateAs<PointXYZRGB>(cloud).triangles, triangles);
  EXPECT_EQ(triangulateAs<PointXYZI>(cloud).triangles, triangles);
  EXPECT_EQ(triangulateAs<PointNormal>(cloud).triangles, triangles);
}

} // namespace
} // namespace pcl::acmap::test
