#include "scene.h"

#include <pcl/conversions.h>
#include <pcl/exceptions.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap {
namespace {

PCLPointCloud2
coloredSquare()
{
  PointCloud<PointXYZRGB> cloud;
  for (const float x : {0.0F, 1.0F})
    for (const float y : {0.0F, 1.0F}) {
      PointXYZRGB point;
      point.getVector3fMap() << x, y, 2;
      point.r = 10;
      point.g = 20;
      point.b = 30;
      cloud.push_back(point);
    }
  PointXYZRGB invalid;
  invalid.x = std::numeric_limits<float>::quiet_NaN();
  cloud.push_back(invalid);
  PCLPointCloud2 blob;
  toPCLPointCloud2(cloud, blob);
  return blob;
}

TEST(Scene, DrawsFinitePointsOfACloud)
{
  const Scene scene = makeScene(coloredSquare(), {});
  EXPECT_FALSE(scene.isMesh());
  ASSERT_EQ(scene.points.size(), 4u);
  EXPECT_EQ(scene.colors[3], (std::array<std::uint8_t, 3>{10, 20, 30}));
}

TEST(Scene, DrawsOnlyCornersOfAMesh)
{
  TriangleMesh mesh;
  mesh.triangles = {{1, 2, 3}, {1, 2, 4}};
  const Scene scene = makeScene(coloredSquare(), mesh);
  EXPECT_EQ(scene.points.size(), 3u);
  ASSERT_EQ(scene.triangles.size(), 1u) << "the one with a point that is not finite";
  EXPECT_EQ(scene.points[static_cast<std::size_t>(scene.triangles[0][2])].x(), 1);
}

TEST(Scene, RefusesWhatItCannotDraw)
{
  TriangleMesh mesh;
  mesh.triangles = {{0, 1, 5}};
  EXPECT_THROW(makeScene(coloredSquare(), mesh), BadArgumentException);
  mesh.triangles = {{0, -1, 2}};
  EXPECT_THROW(makeScene(coloredSquare(), mesh), BadArgumentException);
  EXPECT_THROW(makeScene(PCLPointCloud2(), {}), BadArgumentException);

  PCLPointCloud2 short_of_bytes = coloredSquare();
  short_of_bytes.data.resize(40);
  EXPECT_THROW(makeScene(short_of_bytes, {}), BadArgumentException);
  PCLPointCloud2 empty = coloredSquare();
  empty.width = 0;
  EXPECT_THROW(makeScene(empty, {}), InitFailedException);
}

TEST(Scene, BoundaryIsWhatOneTriangleHas)
{
  const auto edges = boundaryEdges({{0, 1, 2}, {2, 1, 3}});
  EXPECT_EQ(edges.size(), 4u);
  for (const auto& edge : edges)
    EXPECT_NE(edge, (std::array<std::int32_t, 2>{1, 2}));
}

TEST(Scene, MeanNormalOfAFlatMeshIsItsNormal)
{
  TriangleMesh mesh;
  mesh.triangles = {{0, 2, 1}, {2, 3, 1}};
  const Eigen::Vector3d normal = meanNormal(makeScene(coloredSquare(), mesh));
  EXPECT_NEAR((normal - Eigen::Vector3d::UnitZ()).norm(), 0, 1e-12);
}

TEST(Scene, PolygonsBecomeFans)
{
  PolygonMesh mesh;
  mesh.polygons.resize(1);
  mesh.polygons[0].vertices = {4, 5, 6, 7};
  const TriangleMesh triangles = trianglesOf(mesh);
  ASSERT_EQ(triangles.triangles.size(), 2u);
  EXPECT_EQ(triangles.triangles[1], (TriangleMesh::Triangle{4, 6, 7}));
}

} // namespace
} // namespace pcl::acmap
