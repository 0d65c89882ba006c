#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_types.h>

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

} // namespace
} // namespace pcl::acmap::test
