#include "room_views.h"

#include <pcl/core/random.h>
#include <pcl/egomotion/visual_egomotion.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {

namespace {

using Egomotion = VisualEgomotion<PointXYZRGBSigma>;
using Cloud = PointCloud<PointXYZRGBSigma>;

/** \brief Two views of a room with noise, and the motion between them. */
struct RoomViewPair {
  Cloud::ConstPtr source, target;
  Eigen::Isometry3d truth;
};

RoomViewPair
randomPair(std::uint64_t seed, MotionModel model, const Room& now, const Room& before)
{
  Random random(seed);
  const auto value = [&](double maximum) { return random.uniform(-maximum, maximum); };
  const bool is_rigid = model == MotionModel::Rigid;
  Eigen::Isometry3d motion = poseOf({value(0.15), 0, value(0.2)}, value(0.1));
  if (is_rigid)
    motion = motion * poseOf({0, value(0.1), 0}, 0, value(0.06), value(0.06));
  const Eigen::Isometry3d pose =
      poseOf({value(1), value(0.2), value(1) - 0.5}, value(0.5));
  RoomCamera camera;
  camera.width = 240;
  camera.height = 180;
  camera.focal_length = 200;
  camera.noise = 1;
  camera.seed = 2 * seed;
  const auto target = viewOf(before, pose, camera);
  camera.seed = 2 * seed + 1;
  return {viewOf(now, pose * motion, camera), target, motion};
}

RoomViewPair
randomPair(std::uint64_t seed, MotionModel model)
{
  return randomPair(seed, model, Room(seed), Room(seed));
}

std::optional<EgomotionEstimate>
estimateOf(Egomotion& egomotion, const RoomViewPair& pair, MotionModel model)
{
  egomotion.setMotionModel(model);
  egomotion.setInputSource(pair.source);
  egomotion.setInputTarget(pair.target);
  return egomotion.compute();
}

/** \brief Mean squared error per degree of freedom, in units of the variance. */
double
meanSquaredDeviation(MotionModel model, bool refines)
{
  constexpr int runs = 16;
  const Eigen::Index freedom = model == MotionModel::Rigid ? 6 : 3;
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const RoomViewPair pair = randomPair(seed, model);
    Egomotion egomotion;
    egomotion.setRefinement(refines);
    const auto estimate = estimateOf(egomotion, pair, model);
    EXPECT_TRUE(estimate) << egomotion.getReport().reason;
    if (!estimate)
      continue;
    const Eigen::Matrix<double, 6, 1> error =
        motionBetween(estimate->T_target_source, pair.truth);
    sum +=
        error.dot(estimate->covariance.completeOrthogonalDecomposition().solve(error));
  }
  return sum / static_cast<double>(runs * freedom);
}

} // namespace

TEST(VisualEgomotionRefinement, actsOnlyWhereAllFitsBetter)
{
  std::size_t refined = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const MotionModel model = seed % 2 ? MotionModel::Planar : MotionModel::Rigid;
    const RoomViewPair pair = randomPair(seed, model);
    Egomotion with, without;
    without.setRefinement(false);
    const auto estimate = estimateOf(with, pair, model);
    const auto of_features = estimateOf(without, pair, model);
    ASSERT_TRUE(estimate && of_features) << seed;
    const EgomotionReport& report = with.getReport();
    EXPECT_FALSE(without.getReport().is_refined);
    if (report.is_refined) {
      ++refined;
      EXPECT_LE(report.surface_after, report.surface_before) << seed;
    }
    else {
      EXPECT_EQ(estimate->T_target_source.matrix(),
                of_features->T_target_source.matrix());
      EXPECT_EQ(estimate->covariance, of_features->covariance);
    }
  }
  EXPECT_GT(refined, 20u);
}

TEST(VisualEgomotionRefinement, isNearerToTheTruth)
{
  double with_error = 0, without_error = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const RoomViewPair pair = randomPair(seed, MotionModel::Rigid);
    Egomotion with, without;
    without.setRefinement(false);
    const auto estimate = estimateOf(with, pair, MotionModel::Rigid);
    const auto of_features = estimateOf(without, pair, MotionModel::Rigid);
    ASSERT_TRUE(estimate && of_features);
    with_error += motionBetween(pair.truth, estimate->T_target_source).squaredNorm();
    without_error +=
        motionBetween(pair.truth, of_features->T_target_source).squaredNorm();
  }
  EXPECT_LT(with_error, 0.5 * without_error);
}

TEST(VisualEgomotionRefinement, covarianceIsHonest)
{
  for (const MotionModel model : {MotionModel::Planar, MotionModel::Rigid})
    for (const bool refines : {false, true}) {
      SCOPED_TRACE(model == MotionModel::Rigid ? "rigid" : "planar");
      SCOPED_TRACE(refines ? "refined" : "features");
      const double mean = meanSquaredDeviation(model, refines);
      EXPECT_GT(mean, 0.03);
      EXPECT_LT(mean, 3);
    }
}

// A person in front of the wall has moved independently; since the person is close,
// these matches are the precise ones. The person must be rejected, or no motion
// returned.
TEST(VisualEgomotionRefinement, whatMovesAloneDoesNotSpoilIt)
{
  const Eigen::Isometry3d before = poseOf({-0.1, 0, -0.2}, 0.05);
  const Eigen::Isometry3d motion = poseOf({0.05, 0, 0.1}, 0.04);
  std::size_t told = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const auto& [depth, width] :
         {std::pair{1.6, 0.5}, std::pair{2.5, 0.5}, std::pair{2.5, 0.8}}) {
      const auto roomOf = [&, depth = depth, width = width](double x) {
        Room room(seed);
        const Box person(Eigen::Vector3d(x, -0.7, depth),
                         Eigen::Vector3d(x + width, 1.2, depth + 0.3));
        room.things = {person};
        room.brightness =
            [person, x, wall = SpacePaint(seed), clothes = SpacePaint(seed + 50)](
                const Eigen::Vector3d& place, const Eigen::Vector2d&) {
              return person.exteriorDistance(place) < 1e-3
                         ? clothes(place - Eigen::Vector3d(x, 0, 0))
                         : wall(place);
            };
        return room;
      };
      RoomCamera camera;
      camera.noise = 1;
      const Cloud::ConstPtr target = viewOf(roomOf(-0.5), before, camera);
      camera.seed = 2;
      const Cloud::ConstPtr source = viewOf(roomOf(-0.1), before * motion, camera);
      Egomotion egomotion;
      const auto estimate =
          estimateOf(egomotion, {source, target, motion}, MotionModel::Planar);
      if (!estimate)
        continue;
      ++told;
      const Eigen::Matrix<double, 6, 1> error =
          motionBetween(motion, estimate->T_target_source);
      EXPECT_LT(error.head<3>().norm(), 0.03) << depth << " " << width;
      EXPECT_LT(error.tail<3>().norm(), 0.005) << depth << " " << width;
    }
  EXPECT_GE(told, 6u);
}

} // namespace pcl::acmap::test
