#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>
#include <pcl/pipeline/cloud_meshing.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace pcl::acmap::test {
namespace {

/** A wall of 2 m by 2 m, 3 m ahead, with noise along z. */
CloudRows
noisyWall(int side, double noise)
{
  PointCloud<PointXYZ> cloud;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const double wave = std::sin(12.9898 * i + 78.233 * k) * 43758.5453;
      cloud.emplace_back(
          static_cast<float>(2.0 * i / side - 1),
          static_cast<float>(2.0 * k / side - 1),
          static_cast<float>(3 + noise * (2 * (wave - std::floor(wave)) - 1)));
    }
  const auto rows = std::make_shared<PCLPointCloud2>();
  toPCLPointCloud2(cloud, *rows);
  return CloudRows(PCLPointCloud2::ConstPtr(rows));
}

TEST(CloudMeshing, MakesAMeshOfTheCloudAsItIs)
{
  const MeshedCloud made = meshCloud(noisyWall(40, 0), PointCloudFile(), {});
  EXPECT_EQ(made.vertices.size(), 1600U);
  EXPECT_GT(made.mesh.triangles.size(), 2 * 1500U);
  EXPECT_EQ(made.triangulation.triangles, made.mesh.triangles.size());
  EXPECT_FALSE(made.consolidation);
  EXPECT_FALSE(made.names_views);
  EXPECT_EQ(made.steps.seconds.size(), 2U);
}

TEST(CloudMeshing, NoiseIsTakenOutBefore)
{
  CloudMeshing meshing;
  meshing.consolidates = true;
  meshing.consolidation.setVoxelSize(0.1);
  const MeshedCloud made = meshCloud(noisyWall(100, 0.02), PointCloudFile(), meshing);
  ASSERT_TRUE(made.consolidation);
  EXPECT_LT(made.vertices.size(), 2000U);
  EXPECT_NEAR(made.consolidation->voxel_size, 0.1, 1e-9);
  EXPECT_GT(made.mesh.triangles.size(), 100U);
  EXPECT_EQ(meshing.triangulation.getMaximumEdgeLength(), 0) << "settings are copied";
}

TEST(CloudMeshing, AsksForMemoryAndMayBeStopped)
{
  CloudMeshing meshing;
  std::size_t asked = 0;
  meshing.cost = [&](const std::string&, std::size_t bytes, double) { asked = bytes; };
  meshCloud(noisyWall(20, 0), PointCloudFile(), meshing);
  EXPECT_GT(asked, 400 * 12U);
  meshing.progress = [](double, const std::string&) { return false; };
  EXPECT_THROW(meshCloud(noisyWall(20, 0), PointCloudFile(), meshing),
               CancelledException);
}

TEST(CloudMeshing, OfNothingIsEmpty)
{
  for (const bool consolidates : {false, true}) {
    CloudMeshing meshing;
    meshing.consolidates = consolidates;
    const MeshedCloud made = meshCloud(noisyWall(0, 0), PointCloudFile(), meshing);
    EXPECT_TRUE(made.mesh.triangles.empty());
  }
}

} // namespace
} // namespace pcl::acmap::test
