#include "cloud_values.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/core/point_types.h>
#include <pcl/core/random.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;

/** An organized cloud; every third pixel has no position, all have a colour. */
PointCloud<PointXYZRGBSigma>
observation()
{
  PointCloud<PointXYZRGBSigma> cloud(13, 7);
  Random random(11);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    PointXYZRGBSigma& point = cloud[i];
    for (float* value : {&point.x, &point.y, &point.z, &point.sigma})
      *value = i % 3 == 0 ? std::numeric_limits<float>::quiet_NaN()
                          : static_cast<float>(random.normal());
    point.rgba = static_cast<std::uint32_t>(random.bits());
  }
  cloud.is_dense = false;
  return cloud;
}

TEST(PointXYZRGBSigma, SurvivesItsFile)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("observation_0000.pcd");
  const auto cloud = observation();
  PCLPointCloud2 blob;
  toPCLPointCloud2(cloud, blob);
  savePointCloud(path, blob);
  const PointCloudFile file = loadPointCloud(path);
  EXPECT_THAT(namesOf(file.cloud), ElementsAre("x", "y", "z", "rgb", "sigma"));
  EXPECT_EQ(file.cloud.point_step, 5 * sizeof(float));
  expectEqual(file.cloud, blob);
  PointCloud<PointXYZRGBSigma> read;
  fromPCLPointCloud2(file.cloud, read);
  ASSERT_EQ(read.width, cloud.width);
  ASSERT_EQ(read.height, cloud.height);
  EXPECT_FALSE(read.is_dense);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_EQ(read[i].rgba, cloud[i].rgba);
    EXPECT_EQ(rawBytes(read[i].sigma), rawBytes(cloud[i].sigma));
    EXPECT_EQ(rawBytes(read[i].z), rawBytes(cloud[i].z));
  }
}

TEST(PointXYZRGBSigma, IsBlackAndOpaqueInTheOriginAtFirst)
{
  const PointXYZRGBSigma point;
  EXPECT_EQ(sizeof(point), 32u);
  EXPECT_EQ(point.getVector4fMap(), Eigen::Vector4f(0, 0, 0, 1));
  EXPECT_EQ(point.getRGBAVector4i(), Eigen::Vector4i(0, 0, 0, 255));
  EXPECT_EQ(point.sigma, 0.0F);
}

} // namespace
} // namespace pcl::acmap::test
