#include "cloud_values.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/random.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

enum class Encoding { ascii, binary, binary_compressed };

/** Round trips with PCL in both directions, for any point type. */
class PcdRoundTrip : public testing::TestWithParam<Encoding> {
protected:
  template <typename PointT>
  PointCloudFile
  writeAndLoad(const PointCloud<PointT>& cloud)
  {
    const std::string path = folder_.path("cloud of points.pcd");
    PCDWriter writer;
    switch (GetParam()) {
    case Encoding::ascii:
      writer.writeASCII(path, cloud, std::numeric_limits<float>::max_digits10);
      break;
    case Encoding::binary:
      writer.writeBinary(path, cloud);
      break;
    case Encoding::binary_compressed:
      writer.writeBinaryCompressed(path, cloud);
      break;
    }
    PCDReader().read(path, by_pcl_);
    return loadPointCloud(path);
  }

  PointCloudFile
  writeAndLoad(const PCLPointCloud2& cloud)
  {
    const std::string path = folder_.path("padded.pcd");
    const Eigen::Vector4f origin = Eigen::Vector4f::Zero();
    const Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
    PCDWriter writer;
    switch (GetParam()) {
    case Encoding::ascii:
      writer.writeASCII(path, cloud, origin, orientation, 9);
      break;
    case Encoding::binary:
      writer.writeBinary(path, cloud, origin, orientation);
      break;
    case Encoding::binary_compressed:
      writer.writeBinaryCompressed(path, cloud, origin, orientation);
      break;
    }
    return loadPointCloud(path);
  }

  TemporaryFolder folder_;
  PCLPointCloud2 by_pcl_;
};

template <typename PointT>
PointCloud<PointT>
randomCloud(unsigned width, unsigned height)
{
  PointCloud<PointT> cloud(width, height);
  Random random(7);
  for (PointT& point : cloud)
    for (float* value : {&point.x, &point.y, &point.z})
      *value = static_cast<float>(random.normal());
  return cloud;
}

TEST_P(PcdRoundTrip, keepsAnOrganizedCloudWithHoles)
{
  auto cloud = randomCloud<PointXYZ>(37, 29);
  cloud(3, 4).x = std::numeric_limits<float>::quiet_NaN();
  cloud(5, 6).z = std::numeric_limits<float>::infinity();
  const PointCloudFile file = writeAndLoad(cloud);
  expectEqual(file.cloud, by_pcl_);
  EXPECT_EQ(file.cloud.is_dense, 0);
  EXPECT_TRUE(file.remarks.empty());
}

TEST_P(PcdRoundTrip, keepsColoursNormalsAndLabels)
{
  auto coloured = randomCloud<PointXYZRGBNormal>(500, 1);
  auto labelled = randomCloud<PointXYZRGBL>(500, 1);
  for (unsigned i = 0; i < 500; ++i) {
    coloured[i].rgba = 0x00102030U + i;
    coloured[i].getNormalVector3fMap() = Eigen::Vector3f(0.6F, 0.8F, 0.0F);
    labelled[i].label = 4000000000U + i;
    labelled[i].rgba = 0xff000000U + i;
  }
  expectEqual(writeAndLoad(coloured).cloud, by_pcl_);
  expectEqual(writeAndLoad(labelled).cloud, by_pcl_);
}

TEST_P(PcdRoundTrip, keepsFieldsOfSeveralValues)
{
  PCLPointCloud2 blob;
  toPCLPointCloud2(randomCloud<PointXYZRGBNormal>(20, 1), blob);
  // One field of four values instead of the normals.
  blob.fields.resize(5);
  blob.fields[4].name = "descriptor";
  blob.fields[4].count = 4;
  expectEqual(writeAndLoad(blob).cloud, blob);
}

// The fields of this type are not in the order of their offsets. For such types PCL
// writes binary padding with a negative COUNT, for which its reader needs minutes.
TEST_P(PcdRoundTrip, leavesPaddingOut)
{
  PCLPointCloud2 blob;
  toPCLPointCloud2(randomCloud<PointXYZRGBNormal>(50, 2), blob);
  const PointCloudFile file = writeAndLoad(blob);
  expectEqual(file.cloud, blob);
  EXPECT_EQ(namesOf(file.cloud).size(), file.cloud.fields.size());
  EXPECT_TRUE(file.remarks.empty());
}

TEST_P(PcdRoundTrip, keepsTheViewpoint)
{
  auto cloud = randomCloud<PointXYZ>(5, 1);
  const Eigen::Quaternionf orientation(
      Eigen::AngleAxisf(0.7F, Eigen::Vector3f(1, 2, 3).normalized()));
  cloud.sensor_origin_ = Eigen::Vector4f(1.5F, -2.0F, 0.25F, 0.0F);
  cloud.sensor_orientation_ = orientation;
  const PointCloudFile file = writeAndLoad(cloud);
  EXPECT_EQ(file.sensor_origin, Eigen::Vector3f(1.5F, -2.0F, 0.25F));
  EXPECT_LT(file.sensor_orientation.angularDistance(orientation), 1e-4F);
}

TEST_P(PcdRoundTrip, viewReadsTheCoordinates)
{
  const auto cloud = randomCloud<PointXYZI>(11, 1);
  const PointCloudFile file = writeAndLoad(cloud);
  ASSERT_EQ(file.points().size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_EQ(file.points()[i], cloud[i].getVector3fMap());
}

INSTANTIATE_TEST_SUITE_P(Encodings,
                         PcdRoundTrip,
                         testing::Values(Encoding::ascii,
                                         Encoding::binary,
                                         Encoding::binary_compressed));

} // namespace
} // namespace pcl::acmap::test
