#include "rectification_worlds.h"

#include <pcl/core/exceptions.h>
#include <pcl/mapping/map_verdict.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using Verdict = MapVerdict<PointNormal>;

constexpr Drift usual{0.03, 0.006, 0.002};

std::vector<Eigen::Isometry3d>
inSpace(const std::vector<PlanarPose>& poses)
{
  std::vector<Eigen::Isometry3d> all;
  for (const PlanarPose& pose : poses)
    all.push_back(isometryOf(pose));
  return all;
}

/** \param[in] judged empty: the odometry */
MapVerdictReport
verdictOn(const World& world,
          const std::vector<PlanarPose>& odometry,
          const std::vector<PlanarPose>& judged,
          unsigned threads = 0)
{
  Verdict verdict;
  for (std::size_t i = 0; i < odometry.size(); ++i)
    verdict.addPointCloud(world.truth.clouds[i], isometryOf(odometry[i]));
  verdict.setJudgedPoses(inSpace(judged));
  verdict.setNumberOfThreads(threads);
  verdict.compute();
  return verdict.getReport();
}

/** Poses of which those from one on are moved and turned about it. */
std::vector<PlanarPose>
bentAt(const std::vector<PlanarPose>& poses, std::size_t at, const PlanarAction& bend)
{
  std::vector<PlanarPose> bent(poses.begin(),
                               poses.begin() + static_cast<std::ptrdiff_t>(at));
  PlanarPose from = moved(poses[at], bend);
  bent.push_back(from);
  for (std::size_t i = at + 1; i < poses.size(); ++i)
    bent.push_back(moved(bent.back(), actionBetween(poses[i - 1], poses[i])));
  return bent;
}

class JudgedWorld : public testing::TestWithParam<World (*)(std::uint64_t)> {};

TEST_P(JudgedWorld, theTruthIsBetterThanDriftedOdometry)
{
  const World world = GetParam()(51);
  const auto odometry = drifted(world.truth.poses, {0.06, 0.02, 0.006}, 51);
  const MapVerdictReport report = verdictOn(world, odometry, world.truth.poses);
  EXPECT_EQ(report.outcome, VerdictOutcome::Consistent) << report.reasons.front();
  EXPECT_LT(report.probability_worse, 0.05);
  EXPECT_LT(report.e95, report.e95_given);
}

TEST_P(JudgedWorld, aBentMapIsWorseThanGoodOdometry)
{
  const World world = GetParam()(52);
  const auto& truth = world.truth.poses;
  const auto odometry = drifted(truth, {0.005, 0.001, 0}, 52);
  for (const PlanarAction& bend : {PlanarAction{0, 1.5, 0}, PlanarAction{0, 0, 0.3}}) {
    const MapVerdictReport report =
        verdictOn(world, odometry, bentAt(truth, truth.size() / 2, bend));
    EXPECT_NE(report.outcome, VerdictOutcome::Consistent);
  }
}

INSTANTIATE_TEST_SUITE_P(MapVerdict,
                         JudgedWorld,
                         testing::Values(makeRoomWorld,
                                         makeCornerWorld,
                                         makeLoopWorld));

TEST(MapVerdict, doesNotDependOnTheFrameOfTheJudgedPoses)
{
  const World world = makeLoopWorld(53);
  const auto odometry = drifted(world.truth.poses, usual, 53);
  std::vector<PlanarPose> elsewhere;
  for (const PlanarPose& pose : world.truth.poses)
    elsewhere.push_back(moved({7, -3, 1.1}, {pose.x, pose.z, pose.theta}));
  const MapVerdictReport here = verdictOn(world, odometry, world.truth.poses);
  const MapVerdictReport there = verdictOn(world, odometry, elsewhere);
  EXPECT_EQ(here.outcome, there.outcome);
  EXPECT_NEAR(here.e95, there.e95, 1e-6);
  EXPECT_NEAR(here.probability_worse, there.probability_worse, 0.03);
}

TEST(MapVerdict, hasTheSameBitsOnAnyNumberOfThreads)
{
  const World world = makeRoomWorld(54);
  const auto odometry = drifted(world.truth.poses, usual, 54);
  const MapVerdictReport one = verdictOn(world, odometry, world.truth.poses, 1);
  const MapVerdictReport four = verdictOn(world, odometry, world.truth.poses, 4);
  EXPECT_EQ(one.e95, four.e95);
  EXPECT_EQ(one.e95_given, four.e95_given);
  EXPECT_EQ(one.probability_worse, four.probability_worse);
  EXPECT_EQ(one.reasons, four.reasons);
}

TEST(MapVerdict, measuresTheBiasOfTheOdometry)
{
  const World world = makeLoopWorld(55);
  std::vector<PlanarPose> odometry{world.truth.poses.front()};
  constexpr double bias = 0.02; // radians a step
  for (std::size_t i = 1; i < world.truth.poses.size(); ++i) {
    PlanarAction action = actionBetween(world.truth.poses[i - 1], world.truth.poses[i]);
    action.dtheta += bias;
    odometry.push_back(moved(odometry.back(), action));
  }
  const MapVerdictReport report = verdictOn(world, odometry, {});
  const MeasuredOdometry::Component& turn = report.odometry.turn;
  EXPECT_GT(turn.steps, odometry.size() / 2);
  const OdometryNoise assumed;
  EXPECT_GT(turn.bias * assumed.turn, 0.4 * bias);
  EXPECT_LT(turn.bias * assumed.turn, 1.2 * bias);
}

TEST(MapVerdict, saysNothingOfOneScanOfNothingAndOfViewsInSpace)
{
  EXPECT_THROW(Verdict().compute(), InitFailedException);
  const World world = makeRoomWorld(56);
  Verdict one;
  one.addPointCloud(world.truth.clouds.front(), Eigen::Isometry3d::Identity());
  one.compute();
  EXPECT_EQ(one.getReport().outcome, VerdictOutcome::Undetermined);
  EXPECT_FALSE(one.getReport().reasons.empty());

  Verdict empty;
  for (int i = 0; i < 5; ++i)
    empty.addPointCloud(std::make_shared<PointCloud<PointNormal>>(),
                        isometryOf({0.1 * i, 0, 0}));
  empty.compute();
  EXPECT_NE(empty.getReport().outcome, VerdictOutcome::Contradicted);
  EXPECT_TRUE(std::isfinite(empty.getReport().e95));

  Verdict space;
  for (int i = 0; i < 3; ++i) {
    const auto cloud =
        std::make_shared<PointCloud<PointNormal>>(*world.truth.clouds.front());
    cloud->front().y = 1;
    space.addPointCloud(cloud, Eigen::Isometry3d::Identity());
  }
  space.compute();
  EXPECT_EQ(space.getReport().outcome, VerdictOutcome::Undetermined);
}

TEST(MapVerdict, refusesPosesThatAreNone)
{
  const World world = makeRoomWorld(57);
  Verdict verdict;
  verdict.addPointCloud(world.truth.clouds.front(), Eigen::Isometry3d::Identity());
  Eigen::Isometry3d bad = Eigen::Isometry3d::Identity();
  bad.translation().x() = std::nan("");
  EXPECT_THROW(verdict.setJudgedPoses({bad}), BadArgumentException);
  verdict.setJudgedPoses(
      std::vector<Eigen::Isometry3d>(2, Eigen::Isometry3d::Identity()));
  EXPECT_THROW(verdict.compute(), BadArgumentException);
  EXPECT_THROW(verdict.setOdometryNoise({-1, 0, 0, 0}), BadArgumentException);
  EXPECT_THROW(verdict.setUpDirection(Eigen::Vector3d::Zero()), BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
