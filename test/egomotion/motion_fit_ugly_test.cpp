#include "motion_problems.h"

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

using Places = std::vector<Eigen::Vector3d>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/** For all models and solvers. */
class UglyPairs : public testing::TestWithParam<std::tuple<MotionModel, MotionSolver>> {
protected:
  Eigen::Isometry3d
  motionOf(const Places& source,
           const Places& target,
           const std::vector<double>& weights = {}) const
  {
    const MotionFit found = fitMotion(
        source, target, weights, std::get<0>(GetParam()), std::get<1>(GetParam()));
    EXPECT_TRUE(found.T_target_source.matrix().allFinite());
    EXPECT_TRUE(std::isfinite(found.energy));
    EXPECT_NEAR(found.T_target_source.linear().determinant(), 1, 1e-12);
    return found.T_target_source;
  }

  static bool
  isIdentity(const Eigen::Isometry3d& motion)
  {
    return motion.matrix() == Eigen::Matrix4d::Identity();
  }

  const bool is_planar_ = std::get<0>(GetParam()) == MotionModel::Planar;
};

TEST_P(UglyPairs, nothingToGoByLeavesAllAsItIs)
{
  const Places some{{1, 2, 3}, {4, 5, 6}, {7, 8, 0}},
      others{{0, 2, 3}, {4, 5, 1}, {7, 0, 9}};
  EXPECT_TRUE(isIdentity(motionOf({}, {})));
  EXPECT_TRUE(isIdentity(motionOf(some, others, {0, 0, 0})));
  EXPECT_TRUE(isIdentity(motionOf(some, Places(3, {nan, 0, 0}))));
  EXPECT_TRUE(isIdentity(motionOf(Places(3, {0, infinity, 0}), some)));
}

TEST_P(UglyPairs, onePlaceTellsNoTurn)
{
  const Eigen::Vector3d from(0.1, 0.2, 1e4), to(0.7, 0.5, 1e4 + 2);
  for (const std::size_t pairs : {1, 2, 100}) {
    const Eigen::Isometry3d motion = motionOf(Places(pairs, from), Places(pairs, to));
    EXPECT_EQ(motion.linear(), Eigen::Matrix3d::Identity());
    const Eigen::Vector3d wanted(0.6, is_planar_ ? 0 : 0.3, 2);
    EXPECT_LT((motion.translation() - wanted).norm(), 1e-9);
  }
}

TEST_P(UglyPairs, aLineTellsNoTurnAboutItself)
{
  Places source, target;
  const Eigen::Isometry3d truth = planarMotion(0.3, -0.2, 0.4);
  for (int i = 0; i < 5; ++i) {
    source.emplace_back(0.5 * i, 0, 2 + i);
    target.push_back(truth * source.back());
  }
  EXPECT_LT(difference(motionOf(source, target), truth, source), 1e-9);

  // a vertical line; the smallest rotation is none
  Places pole;
  for (int i = 0; i < 5; ++i)
    pole.emplace_back(1, 0.3 * i, 4);
  Places shifted;
  for (const Eigen::Vector3d& place : pole)
    shifted.push_back(place + Eigen::Vector3d(0.1, 0, 0.2));
  EXPECT_LT(difference(motionOf(pole, shifted),
                       Eigen::Isometry3d(Eigen::Translation3d(0.1, 0, 0.2)),
                       pole),
            1e-9);
}

TEST_P(UglyPairs, twoPairsAreALine)
{
  const Eigen::Isometry3d truth = planarMotion(1, 2, -0.7);
  const Places source{{1, 0.5, 0}, {0, 0.5, 3}};
  const Places target{truth * source[0], truth * source[1]};
  EXPECT_LT(difference(motionOf(source, target), truth, source), 1e-9);
}

/** The identity is a maximum of the energy with zero gradient there. */
TEST_P(UglyPairs, halfATurnIsFound)
{
  Places source, target;
  const Eigen::Isometry3d truth = planarMotion(0, 0, M_PI);
  for (const double x : {-1, 1})
    for (const double y : {-1, 1})
      for (const double z : {-2, 2}) {
        source.emplace_back(x, y, z);
        target.emplace_back(-x, y, -z);
      }
  EXPECT_LT(difference(motionOf(source, target), truth, source), 1e-9);
}

TEST_P(UglyPairs, aMirrorIsNoMotion)
{
  Places source, target;
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const double x = random.normal(), y = random.normal();
    source.emplace_back(x, 2 * y, 3 * random.normal());
    target.emplace_back(-source.back().x(), source.back().y(), source.back().z());
  }
  motionOf(source, target); // must have determinant 1
}

TEST_P(UglyPairs, pairsThatAreNotFiniteDoNotCount)
{
  Places source{{0, 0, 1}, {1, 0, 2}, {0, 1, 3}, {2, 2, 1}}, target;
  const Eigen::Isometry3d truth = planarMotion(0.2, 0.1, 0.3);
  for (const Eigen::Vector3d& place : source)
    target.push_back(truth * place);
  std::vector<double> weights{1, 2, 3, 4};
  for (const double bad : {nan, infinity, -infinity, 1e200, 1e308}) {
    source.emplace_back(0, bad, 1);
    target.emplace_back(5, 5, 5);
    weights.push_back(1);
    source.emplace_back(1, 1, 1);
    target.emplace_back(bad, 5, 5);
    weights.push_back(1);
  }
  for (const double bad : {nan, infinity, 0.0, -1.0}) {
    source.emplace_back(1, 1, 1);
    target.emplace_back(5, 5, 5);
    weights.push_back(bad);
  }
  EXPECT_LT(difference(motionOf(source, target, weights), truth, {{1, 1, 1}}), 1e-9);
}

TEST_P(UglyPairs, sizesAndWeightsBeyondReasonAreTaken)
{
  const Eigen::Isometry3d truth = planarMotion(0, 0, 0.5);
  for (const double size : {1e-150, 1e-9, 1e9, 1e150})
    for (const double weight : {1e-310, 1e308}) {
      Places source, target;
      for (const Eigen::Vector3d& place :
           Places{{0, 0, 1}, {1, 0, 2}, {0, 1, 3}, {2, 2, 1}}) {
        source.push_back(size * place);
        target.push_back(truth * source.back());
      }
      const MotionFit found = fitMotion(source,
                                        target,
                                        std::vector<double>(4, weight),
                                        std::get<0>(GetParam()),
                                        std::get<1>(GetParam()));
      EXPECT_LT((found.T_target_source.linear() - truth.linear()).norm(), 1e-9)
          << size << ", " << weight;
    }
}

INSTANTIATE_TEST_SUITE_P(
    ModelsAndSolvers,
    UglyPairs,
    testing::Combine(testing::Values(MotionModel::Planar, MotionModel::Rigid),
                     testing::Values(MotionSolver::ConjugateGradient,
                                     MotionSolver::ClosedForm)));

} // namespace
} // namespace pcl::acmap::test
