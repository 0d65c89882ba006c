#include "rectification_runs.h"

#include <pcl/mapping/map_entropy.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Within a level of a search the energy never increases. */
void
expectFallingEnergy(const std::vector<RectificationStep>& steps)
{
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const RectificationStep& last = steps[i - 1];
    if (steps[i].search != last.search || steps[i].bin_size != last.bin_size)
      continue;
    EXPECT_LE(steps[i].energy, last.energy) << steps[i].search << ", step " << i;
    ++pairs;
  }
  EXPECT_GT(pairs, 2U);
  for (const RectificationStep& step : steps) {
    EXPECT_FALSE(step.search.empty());
    EXPECT_GT(step.entropy, 0);
    EXPECT_GE(step.prior, 0);
    EXPECT_TRUE(std::isfinite(step.energy));
  }
}

/** RMS errors, metres. */
struct Errors {
  double before, after;
};

/** Metres, of the positions; the first poses are equal. */
double
largestError(const std::vector<PlanarPose>& poses, const std::vector<PlanarPose>& truth)
{
  double largest = 0;
  for (std::size_t i = 0; i < poses.size(); ++i)
    largest =
        std::max(largest, std::hypot(poses[i].x - truth[i].x, poses[i].z - truth[i].z));
  return largest;
}

Errors
expectRectified(const World& world, const std::vector<PlanarPose>& odometry)
{
  Rectification rectification = rectificationOf(world.truth, odometry);
  rectification.compute();
  const EntropyRectificationReport& report = rectification.getReport();
  expectWholeReport(rectification);
  EXPECT_EQ(report.outcome, RectificationOutcome::Rectified) << report.reason;
  const double before = rmsError(odometry, world.truth.poses);
  const double after = rmsError(planarPosesOf(rectification), world.truth.poses);
  EXPECT_LT(after, 0.75 * before) << report.reason;
  EXPECT_LT(report.after.near_contradictions + report.after.far_contradictions,
            report.before.near_contradictions + report.before.far_contradictions);
  EXPECT_GT(report.before.near_rays, 0.5);
  EXPECT_GT(report.after.rays, 1000U);
  EXPECT_GT(report.evaluations, 20U);
  EXPECT_GT(largestOf(report.moved), 0.5 * before);
  EXPECT_EQ(report.moved[0], 0) << "the first pose stays";
  expectFallingEnergy(report.steps);
  return {before, after};
}

class DriftedWorld : public testing::TestWithParam<World (*)(std::uint64_t)> {};

TEST_P(DriftedWorld, comesToLessThanHalfOfItsError)
{
  Errors sum{0, 0};
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    const World world = GetParam()(seed);
    const Errors errors =
        expectRectified(world, drifted(world.truth.poses, {0.06, 0.012, 0.004}, seed));
    sum = {sum.before + errors.before, sum.after + errors.after};
  }
  EXPECT_LT(sum.after, 0.5 * sum.before);
}

TEST_P(DriftedWorld, staysWithinHalfABinWhereItIsRight)
{
  const World world = GetParam()(4);
  Rectification rectification = rectificationOf(world.truth, world.truth.poses);
  rectification.compute();
  expectWholeReport(rectification);
  EXPECT_LT(largestOf(rectification.getReport().moved), 0.05);
  EXPECT_NE(rectification.getReport().outcome, RectificationOutcome::Refused);
}

INSTANTIATE_TEST_SUITE_P(EntropyRectification,
                         DriftedWorld,
                         testing::Values(makeRoomWorld, makeCornerWorld, makeLoopWorld),
                         [](const auto& at) { return at.param(1).name; });

/** On worlds and seeds that its constants were not chosen with. */
TEST(EntropyRectification, tellsHowFarPosesMayStillBeWrong)
{
  int told = 0, within = 0;
  for (const auto make : {makeRoomWorld,
                          makeCornerWorld,
                          makeLoopWorld,
                          makeAlikeRoomsWorld,
                          makeCombWorld})
    for (const std::uint64_t seed : {51, 52, 53, 54, 55}) {
      const World world = make(seed);
      const auto odometry = drifted(world.truth.poses, drift, seed);
      Rectification rectification = rectificationOf(world.truth, odometry);
      rectification.compute();
      const std::optional<double> left = rectification.getReport().expected_error;
      if (!left)
        continue;
      ++told;
      const double error =
          largestError(planarPosesOf(rectification), world.truth.poses);
      within += error < *left;
    }
  EXPECT_GT(told, 20);
  EXPECT_GE(within, 0.95 * told) << told;
}

/** Windows of neighbours fit well under a small bias of all turns: that does not show that
 * the odometry is more precise than stated. */
TEST(EntropyRectification, removesAnErrorThatOnlyRevisitsShow)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    const World world = makeLoopWorld(seed);
    const auto odometry = drifted(world.truth.poses, {0.001, 0.0001, 0.0004}, seed);
    Rectification rectification = rectificationOf(world.truth, odometry);
    rectification.setOdometryNoise({0.0012, 0, 0.0012, 0});
    rectification.compute();
    EXPECT_LT(rmsError(planarPosesOf(rectification), world.truth.poses),
              0.4 * rmsError(odometry, world.truth.poses));
  }
}

/** Two plain walls only: the position along them is not observable. */
class BareCorridor : public testing::TestWithParam<int> {
protected:
  static double
  lengthOf(const std::vector<PlanarPose>& poses)
  {
    return std::hypot(poses.back().x - poses.front().x,
                      poses.back().z - poses.front().z);
  }

  static void
  expectLengthKept(const Drift& drift, double noise, std::uint64_t seed, double share)
  {
    const auto path = pathThrough({{0, 0}, {0, 19.5}}, 0.5);
    ASSERT_EQ(path.size(), 40U);
    LaserSettings laser;
    laser.noise = noise;
    const PosedClouds truth = scanAlong(makeBareCorridorPlan(), path, laser, seed);
    const auto odometry = drifted(path, drift, seed);
    Rectification rectification = rectificationOf(truth, odometry);
    rectification.compute();
    const double before = lengthOf(odometry);
    EXPECT_NEAR(lengthOf(planarPosesOf(rectification)), before, share * before)
        << rectification.getReport().reason;
  }
};

TEST_P(BareCorridor, keepsTheLengthThatOdometryGaveIt)
{
  constexpr double degree = M_PI / 180;
  expectLengthKept(
      {0.01, 0.2 * degree, 0}, 0.005, static_cast<std::uint64_t>(GetParam()), 0.01);
}

TEST_P(BareCorridor, isNotShrunkWhereItsWallsAreRoughAndTheDriftGreat)
{
  expectLengthKept(
      {0.12, 0.024, 0.008}, 0.03, static_cast<std::uint64_t>(GetParam()), 0.1);
}

TEST_P(BareCorridor, tellsThatItsLengthIsNotKnown)
{
  const auto seed = static_cast<std::uint64_t>(GetParam());
  const auto path = pathThrough({{0, 0}, {0, 19.5}}, 0.5);
  const PosedClouds truth = scanAlong(makeBareCorridorPlan(), path, {}, seed);
  const std::vector<PlanarPose> odometry = drifted(path, drift, seed);
  Rectification rectification = rectificationOf(truth, odometry);
  rectification.compute();
  const double error = largestError(planarPosesOf(rectification), path);
  const std::optional<double> left = rectification.getReport().expected_error;
  if (rectification.getReport().outcome == RectificationOutcome::Rectified) {
    EXPECT_GT(left.value_or(0), error);
    EXPECT_GT(left.value_or(0), 0.1) << "nothing shows the way along the walls";
  }
}

INSTANTIATE_TEST_SUITE_P(EntropyRectification, BareCorridor, testing::Range(1, 6));

TEST(PaperMode, theEnergyFallsAndTheErrorWithIt)
{
  for (const std::uint64_t seed : {1, 2}) {
    const World world = makeRoomWorld(seed);
    const auto odometry = drifted(world.truth.poses, {0.06, 0.012, 0.004}, seed);
    Rectification rectification = rectificationOf(world.truth, odometry);
    rectification.setMode(RectificationMode::Paper);
    rectification.compute();
    const EntropyRectificationReport& report = rectification.getReport();
    expectWholeReport(rectification);
    EXPECT_EQ(report.outcome, RectificationOutcome::Rectified);
    EXPECT_GT(report.accepted_moves, 10U);
    EXPECT_LT(report.accepted_moves, report.votes);
    EXPECT_EQ(report.evaluations, report.votes + 1);
    EXPECT_NEAR(report.moved[0], 0, 1e-12) << "the first pose is given";
    expectFallingEnergy(report.steps);
    EXPECT_LT(rmsError(planarPosesOf(rectification), world.truth.poses),
              0.5 * rmsError(odometry, world.truth.poses));
    for (const RectificationStep& step : report.steps)
      EXPECT_EQ(step.prior, 0);
  }
}

TEST(PaperMode, theLastEnergyIsTheEntropyOfTheMap)
{
  const World world = makeRoomWorld(3);
  const auto odometry = drifted(world.truth.poses, {0.06, 0.012, 0.004}, 3);
  Rectification rectification = rectificationOf(world.truth, odometry);
  rectification.setMode(RectificationMode::Paper);
  rectification.setProjectionWeight(0);
  rectification.setBinSize(0.05);
  rectification.setSmoothing(0.23);
  rectification.compute();
  MapEntropy<PointNormal> entropy;
  entropy.setProjectionWeight(0);
  entropy.setBinSize(0.05);
  entropy.setSmoothing(0.23);
  const auto poses = planarPosesOf(rectification);
  for (std::size_t i = 0; i < poses.size(); ++i)
    entropy.addPointCloud(world.truth.clouds[i], poses[i]);
  // The search also rotates the whole map relative to the bins; its result is rotated
  // back.
  EXPECT_NEAR(rectification.getReport().steps.back().energy,
              entropy.computeExact().total,
              2e-3);
}

TEST(PaperMode, nothingIsRectifiedUnlessAVoteWasAccepted)
{
  const World world = makeRoomWorld(6);
  std::vector<PlanarPose> odometry = drifted(world.truth.poses, drift, 6);
  for (PlanarPose& pose : odometry)
    pose = {pose.x + 5, pose.z + 5, pose.theta};
  Rectification rectification = rectificationOf(world.truth, odometry);
  rectification.setMode(RectificationMode::Paper);
  rectification.setProjectionWeight(0);
  rectification.setBinSize(25); // all points in one bin: the energy is 0
  rectification.setSmoothing(0);
  rectification.compute();
  const EntropyRectificationReport& report = rectification.getReport();
  expectWholeReport(rectification);
  EXPECT_EQ(report.outcome, RectificationOutcome::Kept) << report.reason;
  EXPECT_EQ(report.accepted_moves, 0U);
  EXPECT_EQ(report.votes, 50 * world.truth.poses.size());
  EXPECT_TRUE(isUntouched(rectification, odometry));
}

TEST(PaperMode, theSeedChoosesTheWay)
{
  const World world = makeRoomWorld(5);
  const auto odometry = drifted(world.truth.poses, {0.06, 0.012, 0.004}, 5);
  Rectification first = rectificationOf(world.truth, odometry), second = first,
                other = first;
  for (Rectification* one : {&first, &second, &other})
    one->setMode(RectificationMode::Paper);
  other.setSeed(2);
  for (Rectification* one : {&first, &second, &other})
    one->compute();
  EXPECT_TRUE(haveSamePoses(first, second));
  EXPECT_FALSE(haveSamePoses(first, other));
}

} // namespace
} // namespace pcl::acmap::test
