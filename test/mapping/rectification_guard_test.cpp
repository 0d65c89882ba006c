#include "rectification_runs.h"

#include <array>
#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr Drift usual{0.03, 0.006, 0.002};

constexpr std::array<World (*)(std::uint64_t), 6> worlds{makeRoomWorld,
                                                         makeCornerWorld,
                                                         makeLoopWorld,
                                                         makeAlikeRoomsWorld,
                                                         makeParallelCorridorsWorld,
                                                         makeCombWorld};

Drift
times(double factor)
{
  return {factor * usual.length_per_metre, factor * usual.turn, factor * usual.bias};
}

/** For any outcome, the poses must not be worse than the given ones. */
void
expectNotWorse(Rectification& rectification,
               const World& world,
               const std::vector<PlanarPose>& odometry)
{
  rectification.compute();
  expectWholeReport(rectification);
  const double before = rmsError(odometry, world.truth.poses);
  const double after = rmsError(planarPosesOf(rectification), world.truth.poses);
  EXPECT_LE(after, 1.05 * before + 0.05)
      << world.name << ": " << rectification.getReport().reason;
  if (rectification.getReport().outcome != RectificationOutcome::Rectified) {
    EXPECT_TRUE(isUntouched(rectification, odometry));
  }
}

class GuardedWorld : public testing::TestWithParam<World (*)(std::uint64_t)> {};

TEST_P(GuardedWorld, isNotWorseAfterDriftFourAndEightTimesTheUsual)
{
  for (const double factor : {4.0, 8.0}) {
    SCOPED_TRACE(factor);
    const World world = GetParam()(11);
    const auto odometry = drifted(world.truth.poses, times(factor), 11);
    Rectification rectification = rectificationOf(world.truth, odometry);
    expectNotWorse(rectification, world, odometry);
  }
}

/** The entropy weight is a thousand times larger, with hardly any prior and bins wider
 * than doors: the minimum of the entropy is then a collapsed map. */
TEST_P(GuardedWorld, isNotWorseWhereTheEntropyIsLetLoose)
{
  for (const double bin : {0.5, 2.0}) {
    SCOPED_TRACE(bin);
    const World world = GetParam()(12);
    const auto odometry = drifted(world.truth.poses, usual, 12);
    Rectification rectification = rectificationOf(world.truth, odometry);
    rectification.setEntropyWeight(1e3);
    rectification.setOdometryNoise({0.2, 0.3, 0.2, 0.5});
    rectification.setBinSize(bin);
    expectNotWorse(rectification, world, odometry);
  }
}

TEST_P(GuardedWorld, isNotWorseWithoutNormals)
{
  const World world = GetParam()(13);
  for (const auto& cloud : world.truth.clouds)
    for (PointNormal& point : *cloud)
      point.getNormalVector3fMap().setConstant(std::nanf(""));
  const auto odometry = drifted(world.truth.poses, times(2), 13);
  Rectification rectification = rectificationOf(world.truth, odometry);
  expectNotWorse(rectification, world, odometry);
}

INSTANTIATE_TEST_SUITE_P(EntropyRectification,
                         GuardedWorld,
                         testing::ValuesIn(worlds),
                         [](const auto& at) {
                           std::string name = at.param(1).name;
                           for (char& letter : name)
                             letter = letter == ' ' ? '_' : letter;
                           return name;
                         });

TEST(RectificationGuard, refusesWhatRaysContradictAndSaysSo)
{
  const World world = makeRoomWorld(14);
  const auto odometry = drifted(world.truth.poses, usual, 14);
  Rectification rectification = rectificationOf(world.truth, odometry);
  rectification.setEntropyWeight(1e3);
  rectification.setOdometryNoise({0.2, 0.3, 0.2, 0.5});
  rectification.setBinSize(2);
  rectification.compute();
  const EntropyRectificationReport& report = rectification.getReport();
  EXPECT_EQ(report.outcome, RectificationOutcome::Refused);
  EXPECT_NE(report.reason.find("rays contradict"), std::string::npos) << report.reason;
  EXPECT_NE(report.reason.find(" % of those that near"), std::string::npos)
      << report.reason;
  EXPECT_TRUE(isUntouched(rectification, odometry));
  EXPECT_GT(report.after.near_contradictions + report.after.far_contradictions, 0.1)
      << "of the candidate that was refused";
  EXPECT_FALSE(report.steps.empty());
}

/** The stated noise is nine times the true one: the residuals within windows tell, and
 * entropy does not bend the map. */
TEST(RectificationGuard, theNoiseOfGoodOdometryIsEstimated)
{
  for (const auto make : {makeRoomWorld, makeLoopWorld}) {
    const World world = make(17);
    const auto odometry = drifted(world.truth.poses, times(1.0 / 3), 17);
    Rectification rectification = rectificationOf(world.truth, odometry);
    const OdometryNoise told;
    rectification.setOdometryNoise({3 * told.length,
                                    3 * told.length_per_metre,
                                    3 * told.turn,
                                    3 * told.turn_per_radian});
    expectNotWorse(rectification, world, odometry);
    EXPECT_LT(rectification.getReport().odometry_scale, 0.6) << world.name;
  }
}

TEST(RectificationGuard, aCollapsedMapIsOpenedOrLeftAlone)
{
  const World world = makeRoomWorld(15);
  auto collapsed = world.truth.poses;
  for (PlanarPose& pose : collapsed) {
    pose.x = collapsed[0].x + 0.1 * (pose.x - collapsed[0].x);
    pose.z = collapsed[0].z + 0.1 * (pose.z - collapsed[0].z);
  }
  Rectification rectification = rectificationOf(world.truth, collapsed);
  expectNotWorse(rectification, world, collapsed);
}

TEST(RectificationGuard, noiseWithoutWallsIsNotRectified)
{
  const World room = makeRoomWorld(16);
  for (std::size_t i = 0; i < room.truth.clouds.size(); ++i)
    for (std::size_t p = 0; p < room.truth.clouds[i]->size(); ++p) {
      PointNormal& point = (*room.truth.clouds[i])[p];
      const double angle = 2.399963 * static_cast<double>(p * (i + 1));
      const double range = 1 + 0.37 * static_cast<double>((p * 7919 + i * 104729) % 17);
      point.getVector3fMap() =
          Eigen::Vector3d(range * std::sin(angle), 0, range * std::cos(angle))
              .cast<float>();
      point.getNormalVector3fMap() = -point.getVector3fMap().normalized();
    }
  Rectification rectification = rectificationOf(room.truth, room.truth.poses);
  expectNotWorse(rectification, room, room.truth.poses);
}

} // namespace
} // namespace pcl::acmap::test
