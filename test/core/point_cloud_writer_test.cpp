#include "cloud_values.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/core/random.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

PCLPointCloud2
organizedCloud(unsigned width, unsigned height)
{
  PointCloud<PointXYZRGBL> cloud(width, height);
  Random random(3);
  for (PointXYZRGBL& point : cloud) {
    for (float* value : {&point.x, &point.y, &point.z})
      *value = static_cast<float>(random.normal());
    point.rgba = static_cast<std::uint32_t>(random.bits());
    point.label = static_cast<std::uint32_t>(random.bits());
  }
  cloud(width / 2, height / 2).x = std::numeric_limits<float>::quiet_NaN();
  cloud.is_dense = false;
  PCLPointCloud2 blob;
  toPCLPointCloud2(cloud, blob);
  return blob;
}

class PointCloudWriter : public testing::Test {
protected:
  TemporaryFolder folder_;
  std::string path_ = folder_.path("cloud.PCD");
};

TEST_F(PointCloudWriter, IsReadBackByUsAndByPcl)
{
  const PCLPointCloud2 cloud = organizedCloud(31, 17);
  savePointCloud(path_, cloud);
  const PointCloudFile file = loadPointCloud(path_);
  expectEqual(file.cloud, cloud);
  EXPECT_EQ(file.cloud.is_dense, 0);
  EXPECT_TRUE(file.remarks.empty());
  EXPECT_EQ(file.cloud.point_step, 5 * sizeof(float)) << "padding was written";
  PCLPointCloud2 by_pcl;
  ASSERT_EQ(pcl::io::loadPCDFile(path_, by_pcl), 0);
  expectEqual(by_pcl, cloud);
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(PointCloudWriter, WritesWhatWasReadToTheSameBytes)
{
  savePointCloud(path_, organizedCloud(9, 5));
  const PointCloudFile file = loadPointCloud(path_);
  const std::string again = folder_.path("again.pcd");
  savePointCloud(again, file.cloud, file.sensor_origin, file.sensor_orientation);
  EXPECT_EQ(contentOf(again), contentOf(path_));
}

TEST_F(PointCloudWriter, KeepsEveryDigitOfTheViewpoint)
{
  const Eigen::Vector3f origin(1.0F / 3.0F, -62.399998F, 1e-7F);
  const Eigen::Quaternionf orientation(
      Eigen::AngleAxisf(0.1234567F, Eigen::Vector3f(1, 2, 3).normalized()));
  savePointCloud(path_, organizedCloud(4, 1), origin, orientation);
  const PointCloudFile file = loadPointCloud(path_);
  EXPECT_EQ(file.sensor_origin, origin);
  EXPECT_LT((file.sensor_orientation.coeffs() - orientation.coeffs()).norm(), 2e-7F);
}

TEST_F(PointCloudWriter, AnEmptyCloudIsAFile)
{
  PCLPointCloud2 cloud = organizedCloud(2, 1);
  cloud.width = 0;
  cloud.data.clear();
  savePointCloud(path_, cloud);
  EXPECT_EQ(loadPointCloud(path_).points().size(), 0u);
}

TEST_F(PointCloudWriter, OtherEndingsAreRefused)
{
  for (const char* name : {"cloud.ply", "cloud", "cloud.pcd.txt"})
    EXPECT_THROW(savePointCloud(folder_.path(name), organizedCloud(2, 2)),
                 OutputFileException);
  EXPECT_THROW(savePointCloud(folder_.path("none/a.pcd"), organizedCloud(2, 2)),
               OutputFileException);
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(PointCloudWriter, CloudsThatCannotBeAreRefused)
{
  const PCLPointCloud2 sound = organizedCloud(3, 2);
  const auto refused = [&](const auto& spoil) {
    PCLPointCloud2 cloud = sound;
    spoil(cloud);
    EXPECT_THROW(savePointCloud(path_, cloud), BadArgumentException);
  };
  refused([](PCLPointCloud2& cloud) { cloud.width = 4; });
  refused([](PCLPointCloud2& cloud) { cloud.point_step = 0; });
  refused([](PCLPointCloud2& cloud) { cloud.fields[1].offset = 4000; });
  refused([](PCLPointCloud2& cloud) { cloud.fields[1].count = 4000; });
  refused([](PCLPointCloud2& cloud) { cloud.fields[1].datatype = 200; });
  refused([](PCLPointCloud2& cloud) { cloud.fields[1].name = "z"; });
  refused([](PCLPointCloud2& cloud) { cloud.fields[1].name = "not y"; });
  refused([](PCLPointCloud2& cloud) { cloud.fields[3].name = "a\nDATA ascii"; });
  refused([](PCLPointCloud2& cloud) { cloud.is_bigendian = true; });
  const Eigen::Quaternionf none(0, 0, 0, 0);
  EXPECT_THROW(savePointCloud(path_, sound, Eigen::Vector3f::Zero(), none),
               BadArgumentException);
  EXPECT_EQ(folder_.count(), 0);
}

} // namespace
} // namespace pcl::acmap::test
