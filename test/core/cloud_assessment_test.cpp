#include "scenes_with_up.h"
#include "test_data.h"

#include <pcl/core/cloud_assessment.h>
#include <pcl/core/point_cloud_reader.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace pcl::acmap::test {
namespace {

CloudAssessmentReport
assess(const std::shared_ptr<const PointCloudFile>& file)
{
  CloudAssessment assessment;
  assessment.setInputCloud(file);
  assessment.compute();
  return assessment.getReport();
}

PointCloud<PointXYZ>::Ptr
cloudOf(const SceneWithUp& scene)
{
  const PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
  for (const Eigen::Vector3d& point : scene.points)
    cloud->push_back({static_cast<float>(point.x()),
                      static_cast<float>(point.y()),
                      static_cast<float>(point.z())});
  return cloud;
}

TEST(CloudAssessment, countsWhatIsNoPoint)
{
  const PointCloud<PointXYZ>::Ptr cloud = cloudOf(turnedRoomWithoutCeiling(1));
  const std::size_t points = cloud->size();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  cloud->push_back({nan, 0, 0});
  for (int i = 0; i < 3; ++i)
    cloud->push_back({0, 0, 0});
  cloud->push_back(cloud->front());
  cloud->push_back(cloud->front());
  CloudAssessment assessment;
  assessment.setInputCloud(cloud);
  assessment.compute();
  const CloudAssessmentReport& report = assessment.getReport();
  EXPECT_EQ(report.points, points + 6);
  EXPECT_EQ(report.finite_points, points + 5);
  EXPECT_EQ(report.zero_points, 3U);
  EXPECT_EQ(report.duplicate_points, 2U);
  EXPECT_EQ(report.colors.content, ColorContent::None);
  ASSERT_TRUE(report.noise && report.noise->is_determined);
  EXPECT_NEAR(report.noise->value, 0.004, 0.001);
  ASSERT_TRUE(report.noise->interval);
  EXPECT_LE((*report.noise->interval)[0], report.noise->value);
  EXPECT_GE((*report.noise->interval)[1], report.noise->value);
  EXPECT_NEAR(report.spacing, 0.05, 0.01);
}

TEST(CloudAssessment, findsNoUpDirectionInADoubtfulUnit)
{
  PointCloud<PointXYZ>::Ptr cloud = cloudOf(turnedRoomWithoutCeiling(1));
  CloudAssessment assessment;
  assessment.setInputCloud(cloud);
  assessment.compute();
  EXPECT_EQ(assessment.getReport().up.outcome, UpOutcome::Found);
  for (PointXYZ& point : *cloud)
    point.getVector3fMap() *= 1000;
  assessment.setInputCloud(cloud);
  assessment.compute();
  EXPECT_EQ(assessment.getReport().unit.outcome, UnitOutcome::Doubtful);
  EXPECT_EQ(assessment.getReport().up.outcome, UpOutcome::Assumed);
  EXPECT_EQ(assessment.getReport().up.value, Eigen::Vector3d::UnitZ());
}

TEST(CloudAssessment, takesWhatIsStatedWithoutAsking)
{
  const PointCloud<PointXYZ>::Ptr cloud = cloudOf(turnedRoomWithoutCeiling(1));
  PointCloudFile file = *fileOf(PointCloud<PointXYZ>::ConstPtr(cloud));
  PointCloudReader reader;
  reader.setUpDirection({0, -3, 0});
  reader.setSensorOrigin({1, 2, 1.5});
  reader.setScale(0.5);
  reader.apply(file);
  const CloudAssessmentReport report =
      assess(std::make_shared<const PointCloudFile>(file));
  EXPECT_EQ(report.up.outcome, UpOutcome::Stated);
  EXPECT_EQ(report.up.value, -Eigen::Vector3d::UnitY());
  EXPECT_EQ(report.sensors.outcome, SensorOutcome::Stated);
  EXPECT_EQ(report.unit.outcome, UnitOutcome::Stated);
  EXPECT_EQ(report.unit.value, 0.5);
  EXPECT_NEAR(report.spacing, 0.025, 0.005);
}

TEST(CloudAssessment, readsColoursByTheirContent)
{
  PointCloud<PointXYZRGB> cloud;
  for (int i = 0; i < 100; ++i)
    cloud.push_back(PointXYZRGB(
        static_cast<float>(i % 10), static_cast<float>(i / 10), 0, 0, 0, 0));
  const auto contentOf = [&] {
    const PointCloud<PointXYZRGB>::ConstPtr copy(new PointCloud<PointXYZRGB>(cloud));
    return assess(fileOf(copy)).colors.content;
  };
  EXPECT_EQ(contentOf(), ColorContent::Empty);
  for (PointXYZRGB& point : cloud)
    point.r = 7;
  EXPECT_EQ(contentOf(), ColorContent::One);
  cloud.front().g = 1;
  EXPECT_EQ(contentOf(), ColorContent::Varied);
}

TEST(CloudAssessment, saysOfCloudsThatShowNothingThatItIsAssumed)
{
  for (const std::size_t points : {std::size_t{1}, std::size_t{20}}) {
    PointCloudFile file = *fileOf(PointCloud<PointXYZ>::ConstPtr(
        new PointCloud<PointXYZ>(static_cast<std::uint32_t>(points), 1, {1, 2, 3})));
    const CloudAssessmentReport report =
        assess(std::make_shared<const PointCloudFile>(file));
    EXPECT_EQ(report.up.outcome, UpOutcome::Assumed);
    EXPECT_FALSE(report.noise->is_determined);
    EXPECT_FALSE(report.up.evidence.empty());
    EXPECT_FALSE(report.noise->evidence.empty());
  }
  EXPECT_THROW(CloudAssessment().compute(), InitFailedException);
}

/** The values stand beside the files of others. */
TEST(CloudAssessment, isRightOfFilesOfOthers)
{
  if (!hasTestData("H_field/clouds/room_y_up.ply"))
    GTEST_SKIP() << "H_field is not in the folder that ACMAP_TEST_DATA names";
  const auto assessFile = [](const std::string& name) {
    return assess(std::make_shared<const PointCloudFile>(
        loadPointCloud(testDataPath("H_field/clouds/" + name).string())));
  };
  EXPECT_GT(assessFile("room_y_up.ply").up.value.y(), 0.999);
  const CloudAssessmentReport zeros = assessFile("half_zero.ply");
  EXPECT_EQ(zeros.points, 2 * zeros.zero_points);
  const CloudAssessmentReport alone = assessFile("xyz_only.ply");
  EXPECT_NEAR(zeros.spacing, alone.spacing, 0.01 * alone.spacing);
  for (const char* flat : {"flat_15000.ply", "flat_5000.ply"}) {
    const CloudAssessmentReport report = assessFile(flat);
    EXPECT_LT(report.noise->value, 0.1) << flat;
    EXPECT_NE(report.unit.outcome, UnitOutcome::Stated);
  }
  EXPECT_EQ(assessFile("zero_colour.las").colors.content, ColorContent::Empty);
}

} // namespace
} // namespace pcl::acmap::test
