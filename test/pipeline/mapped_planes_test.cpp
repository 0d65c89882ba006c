#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/pipeline/mapped_planes.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** A triangle, whose vertices are of a plane, of a cylinder and of nothing. */
MappedPlanes
triangle()
{
  MappedPlanes found;
  PointCloud<PointXYZ> vertices;
  for (const PointXYZ& point :
       {PointXYZ(0, 0, 0), PointXYZ(1, 0, 0), PointXYZ(0, 1, 0)})
    vertices.push_back(point);
  PointCloud<Normal> normals(3, 1);
  for (Normal& normal : normals)
    normal.normal_z = 1;
  const PCLPointCloud2::Ptr cloud(new PCLPointCloud2), voted(new PCLPointCloud2);
  toPCLPointCloud2(vertices, *cloud);
  toPCLPointCloud2(normals, *voted);
  found.vertices = cloud;
  found.normals = voted;
  found.mesh.triangles = {{{0, 1, 2}}};
  found.planes.resize(2);
  found.cylinders.resize(1);
  found.labels = {1, -1, -1, 0};
  found.cylinder_labels = {-1, 0, -1, -1};
  found.vertex_labels = {1, -1, -1};
  found.vertex_cylinders = {-1, 0, -1};
  found.up = Eigen::Vector3f(0, 0, 2);
  return found;
}

TEST(MappedPlanes, LabelsOfCylindersFollowThoseOfPlanes)
{
  EXPECT_EQ(labelsOf(triangle()), (std::vector<std::int32_t>{1, 2, -1, 0}));
  EXPECT_EQ(labelsOfVertices(triangle()), (std::vector<std::int32_t>{1, 2, -1}));
  EXPECT_TRUE(labelsOf({}).empty());
}

TEST(MappedPlanes, BecomeAMap)
{
  const CompactMap map = mapOf(triangle());
  EXPECT_EQ(map.planes.size(), 2U);
  EXPECT_EQ(map.cylinders.size(), 1U);
  EXPECT_EQ(map.up, Eigen::Vector3d(0, 0, 1));
}

TEST(MappedPlanes, AreWrittenWithTheirMesh)
{
  const TemporaryFolder folder;
  saveMappedMesh(folder.path("mesh.ply"), triangle());
  PointCloud<PointXYZL> labels;
  PointCloud<PointNormal> normals;
  const PointCloudFile file = loadPointCloud(folder.path("mesh.ply"));
  fromPCLPointCloud2(file.cloud, labels);
  fromPCLPointCloud2(file.cloud, normals);
  ASSERT_EQ(labels.size(), 3U);
  EXPECT_EQ(labels[0].label, 2U);
  EXPECT_EQ(labels[1].label, 3U);
  EXPECT_EQ(labels[2].label, 0U);
  EXPECT_EQ(normals[1].normal_z, 1);
}

} // namespace
} // namespace pcl::acmap::test
