#include "cloud_values.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_types.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

TEST(ScaledCloud, ScalesAllThatIsALength)
{
  PointCloud<PointXYZRGBSigma> points(2, 1);
  points[1].getVector3fMap() << 1000, -2000, 3000;
  points[1].sigma = 20;
  points[1].rgba = 0xff123456;
  PointCloudFile file;
  toPCLPointCloud2(points, file.cloud);
  file.sensor_origin << 500, 0, 0;
  scaleCloud(file, 0.001);
  PointCloud<PointXYZRGBSigma> scaled;
  fromPCLPointCloud2(file.cloud, scaled);
  EXPECT_EQ(scaled[1].getVector3fMap(), Eigen::Vector3f(1, -2, 3));
  EXPECT_FLOAT_EQ(scaled[1].sigma, 0.02F);
  EXPECT_EQ(scaled[1].rgba, points[1].rgba);
  EXPECT_EQ(file.sensor_origin.x(), 0.5F);
}

/** Files of all encodings with 30,000 points, which are several blocks. */
std::vector<std::string>
writeEncodings(const PCLPointCloud2& cloud)
{
  const std::string folder = testing::TempDir();
  std::vector<std::string> paths;
  for (const char* name : {"rows_ascii.pcd",
                           "rows_binary.pcd",
                           "rows_packed.pcd",
                           "rows_ascii.ply",
                           "rows_binary.ply"})
    paths.push_back(folder + name);
  const Eigen::Vector4f origin(1, 2, 3, 0);
  const Eigen::Quaternionf turn = Eigen::Quaternionf::Identity();
  PCDWriter pcd;
  pcd.writeASCII(paths[0], cloud, origin, turn);
  pcd.writeBinary(paths[1], cloud, origin, turn);
  pcd.writeBinaryCompressed(paths[2], cloud, origin, turn);
  PLYWriter ply;
  ply.writeASCII(paths[3], cloud, origin, turn, 8, false);
  ply.writeBinary(paths[4], cloud, origin, turn, false);
  return paths;
}

TEST(CloudRowsOfAFile, AreThoseOfItsCloud)
{
  PointCloud<PointXYZRGBSigma> points(300, 100);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].getVector3fMap() << 0.5F * static_cast<float>(i), 3, -1;
    points[i].sigma = static_cast<float>(i % 7);
    points[i].rgba = static_cast<std::uint32_t>(i);
  }
  points[5].x = std::numeric_limits<float>::quiet_NaN();
  PCLPointCloud2 cloud;
  toPCLPointCloud2(points, cloud);
  for (const std::string& path : writeEncodings(cloud))
    for (const double scale : {1.0, 0.001}) {
      const PointCloudFile expected = loadScaledCloud(path, scale);
      PointCloudFile file;
      const CloudRows rows = loadCloudRows(path, scale, file);
      EXPECT_TRUE(file.cloud.data.empty()) << path;
      EXPECT_EQ(rows.copy().data, expected.cloud.data) << path;
      EXPECT_EQ(rows.layout().width, expected.cloud.width) << path;
      EXPECT_EQ(rows.layout().is_dense, expected.cloud.is_dense) << path;
      EXPECT_EQ(file.sensor_origin, expected.sensor_origin) << path;
      EXPECT_EQ(file.remarks, expected.remarks) << path;
    }
  PointCloudFile none;
  EXPECT_THROW(loadCloudRows("/no/such.pcd", 1, none), InputFileException);
}

} // namespace
} // namespace pcl::acmap::test
