#include "room_views.h"

#include <pcl/egomotion/revisit_detection.h>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::acmap::test {
namespace {

using Detection = RevisitDetection<PointXYZRGBSigma>;
using Clouds = std::vector<PointCloud<PointXYZRGBSigma>::ConstPtr>;
using Poses = std::vector<Eigen::Isometry3d>;

/** Poses that look around twice: the second time from another place, rolled. */
Poses
twoRounds()
{
  constexpr std::size_t round = 6;
  Poses poses;
  for (std::size_t i = 0; i < 2 * round; ++i) {
    const double turn = 2 * M_PI / round * static_cast<double>(i % round);
    poses.push_back(i < round ? poseOf({0, 0, 1}, turn)
                              : poseOf({0.3, -0.1, 1.2}, turn, 0, 0.3));
  }
  return poses;
}

Clouds
viewsOf(const Room& room, const Poses& poses, double noise = 1)
{
  Clouds clouds;
  for (const Eigen::Isometry3d& pose : poses) {
    RoomCamera camera;
    camera.noise = noise;
    camera.seed = clouds.size() + 1;
    clouds.push_back(viewOf(room, pose, camera));
  }
  return clouds;
}

Detection
detectionOf(const Clouds& clouds)
{
  Detection detection;
  detection.setMinimumSeparation(3);
  for (const auto& cloud : clouds)
    detection.addPointCloud(cloud);
  return detection;
}

/** Metres or radians. */
double
errorOf(const Revisit& revisit, const Poses& truth)
{
  const Eigen::Isometry3d motion =
      truth[revisit.earlier].inverse() * truth[revisit.later];
  return motionBetween(motion, revisit.estimate.T_target_source).norm();
}

TEST(RevisitDetection, findsPlacesSeenAgainFromElsewhere)
{
  const Poses truth = twoRounds();
  Detection detection = detectionOf(viewsOf(Room(), truth));
  detection.compute();
  std::vector<char> is_found(truth.size());
  for (const Revisit& revisit : detection.getRevisits()) {
    EXPECT_LT(errorOf(revisit, truth), 0.02) << revisit.earlier << ' ' << revisit.later;
    EXPECT_GE(revisit.later, revisit.earlier + 3);
    EXPECT_LE(revisit.inliers, revisit.matches);
    EXPECT_LT(revisit.contradicted, 0.05);
    is_found[revisit.earlier] = is_found[revisit.later] = 1;
  }
  EXPECT_GE(std::count(is_found.begin(), is_found.end(), 1), 10);
  const RevisitReport& report = detection.getReport();
  EXPECT_EQ(report.views, truth.size());
  EXPECT_EQ(report.verified, detection.getRevisits().size());
  EXPECT_GE(report.proposals, report.consistent);
  EXPECT_GE(report.consistent, report.verified);
}

TEST(RevisitDetection, anotherRoomIsNotTaken)
{
  const Poses poses = twoRounds();
  Clouds clouds = viewsOf(Room(1), poses);
  const Clouds others = viewsOf(Room(2), poses);
  std::copy(others.begin() + 6, others.end(), clouds.begin() + 6);
  Detection detection = detectionOf(clouds);
  detection.setMinimumSeparation(6);
  detection.compute();
  EXPECT_TRUE(detection.getRevisits().empty());
  EXPECT_GT(detection.getReport().keypoints, 1000U);
}

/** Perceptual aliasing: a picture of a place, hung up elsewhere, looks as the place does. */
TEST(RevisitDetection, theSamePictureOnAnotherShapeIsNotTaken)
{
  const Room room;
  Room farther;
  farther.things.clear();
  farther.walls.max().z() = 9; // metres
  const Eigen::Isometry3d pose = poseOf({0, 0, 0}, 0);
  const auto near = viewOf(room, pose), wall = viewOf(farther, pose);
  const auto painted = std::make_shared<PointCloud<PointXYZRGBSigma>>(*wall);
  for (std::size_t i = 0; i < painted->size(); ++i)
    (*painted)[i].rgba = (*near)[i].rgba;
  for (const bool is_same : {true, false}) {
    Detection detection;
    detection.setMinimumSeparation(1);
    detection.addPointCloud(near);
    if (is_same)
      detection.addPointCloud(near);
    else
      detection.addPointCloud(painted);
    detection.compute();
    EXPECT_EQ(detection.getReport().proposals, 1U);
    EXPECT_EQ(detection.getRevisits().size(), is_same ? 1U : 0U);
  }
}

TEST(RevisitDetection, threadsAndRepetitionsDoNotChangeAByte)
{
  const Clouds clouds = viewsOf(Room(), twoRounds());
  std::vector<std::vector<Revisit>> runs;
  for (const unsigned threads : {1U, 2U, 8U, 1U}) {
    Detection detection = detectionOf(clouds);
    detection.setNumberOfThreads(threads);
    detection.compute();
    runs.push_back(detection.getRevisits());
  }
  ASSERT_FALSE(runs[0].empty());
  for (const std::vector<Revisit>& run : runs) {
    ASSERT_EQ(run.size(), runs[0].size());
    for (std::size_t i = 0; i < run.size(); ++i) {
      EXPECT_EQ(run[i].earlier, runs[0][i].earlier);
      EXPECT_EQ(run[i].later, runs[0][i].later);
      EXPECT_EQ(std::memcmp(run[i].estimate.T_target_source.data(),
                            runs[0][i].estimate.T_target_source.data(),
                            16 * sizeof(double)),
                0);
    }
  }
}

TEST(RevisitDetection, uglyViewsHaveNone)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto black = std::make_shared<PointCloud<PointXYZRGBSigma>>(64, 48);
  const auto tiny = std::make_shared<PointCloud<PointXYZRGBSigma>>(2, 2);
  const auto empty = std::make_shared<PointCloud<PointXYZRGBSigma>>();
  const auto nowhere = std::make_shared<PointCloud<PointXYZRGBSigma>>(
      *viewOf(Room(), Eigen::Isometry3d::Identity()));
  for (PointXYZRGBSigma& point : *nowhere)
    point.getVector3fMap().setConstant(nan);
  const auto huge = std::make_shared<PointCloud<PointXYZRGBSigma>>(
      *viewOf(Room(), Eigen::Isometry3d::Identity()));
  for (PointXYZRGBSigma& point : *huge)
    point.getVector3fMap() *= 1e9F;
  Detection detection;
  detection.setMinimumSeparation(1);
  for (const auto& cloud : {black, tiny, empty, nowhere, black, tiny, empty, nowhere})
    detection.addPointCloud(cloud);
  detection.compute();
  EXPECT_TRUE(detection.getRevisits().empty());
  EXPECT_EQ(detection.getReport().invalid_points, 2 * nowhere->size());
  detection.addPointCloud(huge);
  detection.addPointCloud(nowhere);
  detection.addPointCloud(huge);
  EXPECT_NO_THROW(detection.compute());
}

TEST(RevisitDetection, refusesWhatIsNoImage)
{
  Detection detection;
  EXPECT_THROW(detection.compute(), InitFailedException);
  EXPECT_THROW(detection.addPointCloud(nullptr), InitFailedException);
  EXPECT_THROW(
      detection.addPointCloud(std::make_shared<PointCloud<PointXYZRGBSigma>>(100, 1)),
      UnorganizedPointCloudException);
  EXPECT_THROW(detection.setMinimumSeparation(0), BadArgumentException);
  EXPECT_EQ(detection.getMinimumSeparation(), 10U);
}

TEST(RevisitDetection, canBeCancelled)
{
  Detection detection = detectionOf(viewsOf(Room(), twoRounds()));
  detection.compute();
  const std::size_t found = detection.getRevisits().size();
  detection.clear();
  detection.addPointCloud(viewOf(Room(), Eigen::Isometry3d::Identity()));
  for (const char* const step : {"describe", "propose"}) {
    detection.setProgressCallback(
        [&](double, const std::string& now) { return now != step; });
    EXPECT_THROW(detection.compute(), CancelledException);
    EXPECT_EQ(detection.getRevisits().size(), found);
  }
}

} // namespace
} // namespace pcl::acmap::test
