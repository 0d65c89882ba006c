#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/pipeline/map_folder.h>

#include <gmock/gmock.h>

#include <limits>
#include <memory>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Trajectory
posesAt(const std::vector<double>& places)
{
  Trajectory trajectory;
  for (const double x : places) {
    trajectory.stamps.push_back(x);
    trajectory.poses.emplace_back(Eigen::Translation3d(x, 0, 0));
  }
  return trajectory;
}

class MapFolders : public testing::Test {
protected:
  /** A point of each view. */
  void
  writeCloud(const std::vector<int>& views) const
  {
    std::string text = "VERSION 0.7\nFIELDS x y z view\nSIZE 4 4 4 4\nTYPE F F F I\n"
                       "COUNT 1 1 1 1\nWIDTH " +
                       std::to_string(views.size()) +
                       "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
                       std::to_string(views.size()) + "\nDATA ascii\n";
    for (const int view : views)
      text += "1 2 3 " + std::to_string(view) + "\n";
    folder_.write("map.pcd", text);
  }

  void
  writePoses(const char* name, const std::vector<double>& places) const
  {
    saveTrajectory(folder_.path(name), posesAt(places));
  }

  TemporaryFolder folder_;
};

TEST_F(MapFolders, OfARectificationHaveACloudAndPoses)
{
  writeCloud({0, 1, 1});
  EXPECT_THROW(loadMapFolder(folder_.path("")), InputFileException) << "no poses";
  writePoses("trajectory.txt", {0, 1});
  writePoses("trajectory_before.txt", {0, 2});
  const MapFolder result = loadMapFolder(folder_.path(""));
  EXPECT_EQ(result.cloud.width, 3U);
  EXPECT_EQ(result.map.trajectory.poses.size(), 2U);
  ASSERT_EQ(result.trajectory_before.poses.size(), 2U);
  EXPECT_EQ(result.trajectory_before.poses[1].translation().x(), 2);
  EXPECT_TRUE(result.mesh.triangles.empty());
  EXPECT_TRUE(result.remarks.empty());
}

TEST_F(MapFolders, PosesBeforeThatDoNotFitAreTold)
{
  writeCloud({0, 1});
  writePoses("trajectory.txt", {0, 1});
  writePoses("trajectory_before.txt", {0, 1, 2});
  const MapFolder result = loadMapFolder(folder_.path(""));
  EXPECT_EQ(result.trajectory_before.poses.size(), 3U);
  EXPECT_THAT(result.remarks, ElementsAre(HasSubstr("has 3 poses, the map 2")));
}

TEST_F(MapFolders, PointsOfNoPoseAreTold)
{
  writeCloud({0, 5, -1});
  writePoses("trajectory.txt", {0, 1});
  writePoses("trajectory_before.txt", {0, 1});
  EXPECT_THAT(loadMapFolder(folder_.path("")).remarks,
              ElementsAre(HasSubstr("2 points were seen from no pose")));
}

TEST(SequenceSamples, HaveFinitePointsInTheFrameOfTheMap)
{
  constexpr std::size_t points = 1000;
  std::vector<std::shared_ptr<const PointCloudFile>> files;
  for (int i = 0; i < 2; ++i) {
    PointCloud<PointXYZRGB> cloud;
    cloud.resize(points);
    for (PointXYZRGB& point : cloud)
      point.z = 2;
    cloud[0].x = std::numeric_limits<float>::quiet_NaN();
    const auto file = std::make_shared<PointCloudFile>();
    toPCLPointCloud2(cloud, file->cloud);
    files.push_back(file);
  }
  const ObservationSequence sequence(files, posesAt({0, 10}));
  const SequenceSample sample = sampleSequence(sequence, 100);
  EXPECT_EQ(sample.trajectory.poses.size(), 2U);
  EXPECT_GT(sample.points.size(), 60U);
  EXPECT_LE(sample.points.size(), 102U);
  for (const PointXYZRGBNormalView& point : sample.points)
    EXPECT_EQ(point.x, point.view == 0 ? 0 : 10);
  EXPECT_EQ(sampleSequence(sequence, 1000000).points.size(), 2 * (points - 1));
  EXPECT_THROW(
      sampleSequence(sequence, 100, [](double, const std::string&) { return false; }),
      CancelledException);
}

} // namespace
} // namespace pcl::acmap::test
