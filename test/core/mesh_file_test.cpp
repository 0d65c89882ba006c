#include "cloud_values.h"
#include "sample_mesh.h"
#include "temporary_folder.h"

#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void
expectSameFaces(const std::vector<Vertices>& polygons, const TriangleMesh& mesh)
{
  ASSERT_EQ(polygons.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    ASSERT_EQ(polygons[i].vertices.size(), 3U);
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_EQ(polygons[i].vertices[c], mesh.triangles[i][c]);
  }
}

void
expectSameFields(const PCLPointCloud2& cloud,
                 const PCLPointCloud2& expected,
                 const std::vector<std::string>& names)
{
  for (const std::string& name : names)
    EXPECT_EQ(bytesOf(cloud, name), bytesOf(expected, name)) << name;
}

TEST(MeshFile, plyIsReadByPclAndByUs)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("room, 2. floor.ply");
  const SampleMesh sample;
  saveTriangleMesh(path, sample.cloud, sample.mesh);
  PolygonMesh by_pcl;
  ASSERT_EQ(io::loadPLYFile(path, by_pcl), 0);
  expectSameFaces(by_pcl.polygons, sample.mesh);
  expectSameFields(by_pcl.cloud,
                   sample.cloud,
                   {"x", "y", "z", "normal_x", "normal_y", "normal_z", "curvature"});
  const PointCloudFile file = loadPointCloud(path);
  expectSameFields(file.cloud, sample.cloud, namesOf(sample.cloud));
  EXPECT_TRUE(file.remarks.empty());
}

TEST(MeshFile, plyKeepsEveryScalarType)
{
  const TemporaryFolder folder;
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar "
      "blue\n"
      "property uchar alpha\nproperty char a\nproperty uchar b\nproperty short c\n"
      "property ushort d\nproperty int e\nproperty uint f\nproperty double g\n"
      "end_header\n1 2 3 4 5 6 7 -8 9 -10 11 -12 13 0.1\n"
      "3 2 1 7 6 5 4 -1 1 -2 2 -3 3 0.3\n";
  const PCLPointCloud2 cloud = loadPointCloud(folder.write("a.ply", text)).cloud;
  saveTriangleMesh(folder.path("b.ply"), cloud, {});
  expectEqual(loadPointCloud(folder.path("b.ply")).cloud, cloud);
}

TEST(MeshFile, keepsPointsThatAreNotFinite)
{
  SampleMesh sample(3);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(&sample.cloud.data[sample.cloud.point_step], &nan, sizeof(nan));
  const TemporaryFolder folder;
  saveTriangleMesh(folder.path("a.ply"), sample.cloud, sample.mesh);
  const PointCloudFile file = loadPointCloud(folder.path("a.ply"));
  EXPECT_EQ(bytesOf(file.cloud, "x"), bytesOf(sample.cloud, "x"));
  EXPECT_EQ(file.cloud.is_dense, 0);
}

TEST(MeshFile, plyStoresTheWallDepth)
{
  SampleMesh sample(4);
  sample.mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  sample.mesh.wall_depth = {7, TriangleMesh::no_wall};
  const TemporaryFolder folder;
  saveTriangleMesh(folder.path("a.ply"), sample.cloud, sample.mesh);
  const std::string content = contentOf(folder.path("a.ply"));
  EXPECT_THAT(content, HasSubstr("vertex_indices\nproperty uchar wall_depth\n"));
  const auto face = [](int a, int b, int c, char depth) {
    return "\3" + rawBytes(a) + rawBytes(b) + rawBytes(c) + depth;
  };
  EXPECT_EQ(content.substr(content.size() - 28),
            face(0, 1, 2, 7) + face(2, 1, 3, '\xff'));
}

TEST(MeshFile, writesAnEmptyMeshOfAnEmptyCloud)
{
  PCLPointCloud2 cloud;
  toPCLPointCloud2(PointCloud<PointXYZ>(), cloud);
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.vtk"})
    saveTriangleMesh(folder.path(name), cloud, {});
  EXPECT_EQ(loadPointCloud(folder.path("a.ply")).points().size(), 0U);
  EXPECT_GT(contentOf(folder.path("a.vtk")).size(), 0U);
}

TEST(MeshFile, refusesWrongArgumentsAndWritesNothing)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("a.ply");
  const SampleMesh good(3);
  SampleMesh bad = good;
  bad.mesh.triangles[5][1] = 3;
  EXPECT_THROW(saveTriangleMesh(path, bad.cloud, bad.mesh), BadArgumentException);
  bad.mesh.triangles[5][1] = -1;
  EXPECT_THROW(saveTriangleMesh(path, bad.cloud, bad.mesh), BadArgumentException);
  bad.mesh = good.mesh;
  bad.mesh.wall_depth = {1};
  EXPECT_THROW(saveTriangleMesh(path, bad.cloud, bad.mesh), BadArgumentException);
  bad.cloud.data.resize(good.cloud.data.size() - 1);
  EXPECT_THROW(saveTriangleMesh(path, bad.cloud, good.mesh), BadArgumentException);
  bad.cloud = good.cloud;
  bad.cloud.fields[2].offset = bad.cloud.point_step - 3;
  EXPECT_THROW(saveTriangleMesh(path, bad.cloud, good.mesh), BadArgumentException);
  bad.cloud.fields.erase(bad.cloud.fields.begin());
  EXPECT_THROW(saveTriangleMesh(path, bad.cloud, good.mesh), BadArgumentException);
  EXPECT_THROW(saveTriangleMesh(path, PCLPointCloud2(), {}), BadArgumentException);
  EXPECT_THROW(saveTriangleMesh(folder.path("a.stl"), good.cloud, good.mesh),
               OutputFileException);
  EXPECT_EQ(folder.count(), 0);
}

TEST(MeshFile, namesTheFileWhenTheDiskIsFull)
{
  const TemporaryFolder folder;
  const SampleMesh sample(5);
  for (const std::string name : {"full.ply", "full.vtk"}) {
    const std::string path = folder.path(name);
    std::filesystem::create_symlink("/dev/full", path);
    EXPECT_THAT([&] { saveTriangleMesh(path, sample.cloud, sample.mesh); },
                testing::ThrowsMessage<OutputFileException>(
                    HasSubstr(path + ": No space left")));
  }
}

} // namespace
} // namespace pcl::acmap::test
