#include "observation_names.h"
#include "scaled_cloud.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/point_types.h>

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;

TEST(ObservationNames, AreInTheOrderOfTheirNumbers)
{
  EXPECT_THAT(inSequence({"observation_10000.pcd",
                          "map.pcd",
                          "observation_9999.pcd",
                          "observation_x.pcd",
                          "observation_0002.pcd"}),
              ElementsAre("observation_0002.pcd",
                          "observation_9999.pcd",
                          "observation_10000.pcd"));
  EXPECT_THAT(inSequence({"b.pcd", "c.PCD", "a.pcd"}),
              ElementsAre("a.pcd", "b.pcd", "c.PCD"));
}

TEST(ObservationNames, OfAFolderAreItsPcds)
{
  const TemporaryFolder folder;
  EXPECT_THROW(observationNames(folder.path("")), InputFileException);
  EXPECT_THROW(observationNames(folder.write("file.pcd", "")), InputFileException);
  folder.write("notes.txt", "");
  EXPECT_THAT(observationNames(folder.path("")), ElementsAre("file.pcd"));
}

TEST(TrajectoryRows, BelongToFilesInTheirOrderWhereThereAreAsMany)
{
  const std::vector<std::string> names = {
      "observation_0000.pcd", "observation_0002.pcd", "observation_0003.pcd"};
  EXPECT_THAT(trajectoryRows("t", names, 3), ElementsAre(0, 1, 2));
  EXPECT_THAT(trajectoryRows("t", names, 5), ElementsAre(0, 2, 3));
  EXPECT_THAT(trajectoryRows("t", {"a.pcd", "b.pcd"}, 5), ElementsAre(0, 1));
  EXPECT_THROW(trajectoryRows("t", names, 2), InputFileException);
  EXPECT_THROW(trajectoryRows("t", {"a.pcd", "b.pcd"}, 1), InputFileException);
}

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
