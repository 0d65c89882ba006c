#include <pcl/core/random.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

using Poses = std::vector<Eigen::Isometry3d>;

Eigen::Isometry3d
motionOf(double x, double y, double z, double degrees, const Eigen::Vector3d& axis)
{
  Eigen::Isometry3d motion(Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()));
  motion.translation() << x, y, z;
  return motion;
}

Eigen::Isometry3d
randomMotion(Random& random, double metres, double degrees = 60)
{
  const auto value = [&random, metres] { return metres * random.normal(); };
  const double x = value(), y = value(), z = value();
  return motionOf(x, y, z, random.uniform(-degrees, degrees), {x, z, y + 1});
}

Poses
randomWalk(std::uint64_t seed, std::size_t count)
{
  Random random(seed);
  Poses poses{randomMotion(random, 10)};
  while (poses.size() < count)
    poses.push_back(poses.back() * randomMotion(random, 0.5));
  return poses;
}

Poses
movedBy(const Eigen::Isometry3d& motion, const Poses& poses)
{
  Poses moved;
  for (const Eigen::Isometry3d& pose : poses)
    moved.push_back(motion * pose);
  return moved;
}

TEST(MotionError, isThatOfTheMotion)
{
  const Eigen::Isometry3d truth = motionOf(0.3, 0, 0.4, 20, {0, 1, 0});
  const MotionError error =
      motionError(truth * motionOf(0, 0.03, 0.04, 2, {0, 1, 0}), truth);
  EXPECT_NEAR(error.translation, 0.05, 1e-12);
  EXPECT_NEAR(error.rotation, 2 * M_PI / 180, 1e-12);
  EXPECT_NEAR(error.length, 0.5, 1e-12);
}

TEST(MotionError, whatIsNoMotionIsRefused)
{
  Eigen::Isometry3d stretched = Eigen::Isometry3d::Identity();
  stretched.linear() *= 1.01;
  Eigen::Isometry3d lost = Eigen::Isometry3d::Identity();
  lost.translation().x() = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Isometry3d& bad : {stretched, lost}) {
    EXPECT_THROW(motionError(bad, Eigen::Isometry3d::Identity()), BadArgumentException);
    EXPECT_THROW(motionError(Eigen::Isometry3d::Identity(), bad), BadArgumentException);
  }
}

TEST(RelativePoseError, sumsUp)
{
  const RelativePoseError error =
      summaryOf({{0.01, 0.1, 1}, {0.02, 0.3, 1}, {0.06, 0.2, 4}, {0.02, 0, 0}});
  EXPECT_EQ(error.pairs, 4);
  EXPECT_NEAR(error.translation_rms, std::sqrt(0.0045 / 4), 1e-12);
  EXPECT_EQ(error.translation_median, 0.02);
  EXPECT_NEAR(error.rotation_rms, std::sqrt(0.14 / 4), 1e-12);
  EXPECT_EQ(error.rotation_median, 0.2);
  EXPECT_EQ(error.rotation_worst, 0.3);
  EXPECT_NEAR(error.translation_per_metre, 0.11 / 6, 1e-12);
  EXPECT_EQ(error.translation_per_metre_median, 0.06 / 4);
}

TEST(RelativePoseError, nothingHasNoError)
{
  const RelativePoseError error = relativePoseError({}, {});
  EXPECT_EQ(error.pairs, 0);
  EXPECT_TRUE(std::isnan(error.translation_rms));
  EXPECT_TRUE(std::isnan(error.rotation_median));
  EXPECT_TRUE(std::isnan(error.rotation_worst));
  EXPECT_TRUE(std::isnan(error.translation_per_metre));
  EXPECT_EQ(relativePoseError(randomWalk(1, 3), randomWalk(1, 3), 3).pairs, 0);
}

TEST(RelativePoseError, doesNotKnowTheMap)
{
  const Poses truth = randomWalk(2, 20);
  const Poses elsewhere = movedBy(motionOf(5, 6, 7, 80, {1, 2, 3}), truth);
  for (const std::size_t step : {1, 2, 7}) {
    const RelativePoseError error = relativePoseError(elsewhere, truth, step);
    EXPECT_EQ(error.pairs, 20 - step);
    EXPECT_LT(error.translation_rms, 1e-12);
    EXPECT_LT(error.rotation_worst, 1e-7);
  }
}

TEST(RelativePoseError, oneBadMotionIsInEachPairThatSpansIt)
{
  const Poses truth = randomWalk(3, 20);
  Poses found = truth;
  for (std::size_t i = 10; i < found.size(); ++i)
    found[i] =
        found[9] * motionOf(0, 0, 0, 3, {0, 1, 0}) * truth[9].inverse() * truth[i];
  const double turn = 3 * M_PI / 180;
  EXPECT_NEAR(
      relativePoseError(found, truth, 1).rotation_rms, turn * std::sqrt(1. / 19), 1e-9);
  EXPECT_NEAR(
      relativePoseError(found, truth, 4).rotation_rms, turn * std::sqrt(4. / 16), 1e-9);
}

TEST(RelativePoseError, whatCannotBeComparedIsRefused)
{
  EXPECT_THROW(relativePoseError(randomWalk(1, 3), randomWalk(1, 4)),
               BadArgumentException);
  EXPECT_THROW(relativePoseError(randomWalk(1, 3), randomWalk(1, 3), 0),
               BadArgumentException);
}

TEST(RelativePoseError, aPoseThatIsNotRigidIsRefusedWhateverItsMotions)
{
  // motions between mirrored poses are rigid; a single pose has no motion
  const Poses truth = randomWalk(1, 3);
  Poses mirrored = truth;
  for (Eigen::Isometry3d& pose : mirrored)
    pose.matrix().row(0) *= -1;
  Poses lost = truth;
  lost[2].translation().y() = std::numeric_limits<double>::quiet_NaN();
  for (const Poses& bad : {mirrored, lost})
    for (const std::size_t step : {1, 3}) {
      EXPECT_THROW(relativePoseError(bad, truth, step), BadArgumentException);
      EXPECT_THROW(relativePoseError(truth, bad, step), BadArgumentException);
    }
}

TEST(RelativePoseError, ofATruthThatStandsStillThereIsNoneAMetre)
{
  const Poses still(3, Eigen::Isometry3d::Identity());
  for (const Poses& found : {still, randomWalk(1, 3)}) {
    const RelativePoseError error = relativePoseError(found, still);
    EXPECT_EQ(error.pairs, 2);
    EXPECT_TRUE(std::isfinite(error.translation_rms));
    EXPECT_TRUE(std::isnan(error.translation_per_metre));
    EXPECT_TRUE(std::isnan(error.translation_per_metre_median));
  }
}

TEST(AbsoluteTrajectoryError, alignsWithoutScale)
{
  const Poses truth = randomWalk(4, 30);
  const auto moved =
      absoluteTrajectoryError(movedBy(motionOf(1, 2, 3, 100, {3, 2, 1}), truth), truth);
  EXPECT_GT(moved.unaligned, 1);
  EXPECT_LT(moved.aligned, 1e-10);
  const auto shifted = absoluteTrajectoryError(
      movedBy(motionOf(0, 0.3, 0.4, 0, Eigen::Vector3d::UnitX()), truth), truth);
  EXPECT_NEAR(shifted.unaligned, 0.5, 1e-12);
  Poses stretched = truth;
  for (Eigen::Isometry3d& pose : stretched)
    pose.translation() *= 2;
  EXPECT_GT(absoluteTrajectoryError(stretched, truth).aligned, 0.3);
}

/** No other rigid motion aligns the positions better. */
TEST(AbsoluteTrajectoryError, alignsBest)
{
  const Poses truth = randomWalk(5, 30);
  const Poses found = randomWalk(6, 30);
  const double best = absoluteTrajectoryError(found, truth).aligned;
  Random random(7);
  Eigen::Isometry3d fit = Eigen::Isometry3d::Identity();
  double nearest = absoluteTrajectoryError(found, truth).unaligned;
  for (int i = 0; i < 20000; ++i) {
    const double scale = 1. / (1 + i / 100);
    const Eigen::Isometry3d other = randomMotion(random, scale, 60 * scale) * fit;
    const double error =
        absoluteTrajectoryError(movedBy(other, found), truth).unaligned;
    EXPECT_GE(error, best - 1e-9);
    if (error < nearest) {
      nearest = error;
      fit = other;
    }
  }
  EXPECT_LT(nearest, 1.05 * best) << "the search should come near";
}

TEST(AbsoluteTrajectoryError, aPathOnTheFloorIsNotTurnedOver)
{
  std::vector<PlanarPose> left, right;
  Poses left_in_space, right_in_space;
  for (int i = 0; i < 30; ++i) {
    const double x = 0.002 * i * i;
    left.push_back({-x, 0.4 * i, 0});
    right.push_back({x, 0.4 * i, 0});
    left_in_space.push_back(isometryOf(left.back()));
    right_in_space.push_back(isometryOf(right.back()));
  }
  EXPECT_LT(absoluteTrajectoryError(left_in_space, right_in_space).aligned, 1e-9);
  const auto on_floor = absoluteTrajectoryError(left, right);
  EXPECT_GT(on_floor.aligned, 0.1);
  EXPECT_LT(on_floor.aligned, on_floor.unaligned);
}

TEST(AbsoluteTrajectoryError, alignsStraightAndSinglePaths)
{
  const std::vector<PlanarPose> straight{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}};
  const std::vector<PlanarPose> across{{3, 0, 0}, {4, 0, 0}, {5, 0, 0}};
  EXPECT_LT(absoluteTrajectoryError(straight, across).aligned, 1e-12);
  const auto single =
      absoluteTrajectoryError(std::vector<PlanarPose>{{0, 0, 0}}, {{3, 4, 1}});
  EXPECT_EQ(single.unaligned, 5);
  EXPECT_LT(single.aligned, 1e-12);
}

TEST(AbsoluteTrajectoryError, whatCannotBeComparedIsRefused)
{
  EXPECT_THROW(absoluteTrajectoryError(Poses{}, Poses{}), BadArgumentException);
  EXPECT_THROW(absoluteTrajectoryError(randomWalk(1, 3), randomWalk(1, 4)),
               BadArgumentException);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(
      absoluteTrajectoryError(std::vector<PlanarPose>{{infinity, 0, 0}}, {{0, 0, 0}}),
      BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
