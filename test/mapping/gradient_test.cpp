#include "entropy_runs.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

double
differenceOf(MapEntropy<PointNormal>& entropy,
             std::size_t number,
             int axis,
             double step)
{
  const PlanarPose pose = entropy.getPose(number);
  entropy.setPose(number, shifted(pose, axis, step));
  const double after = entropy.compute().total;
  entropy.setPose(number, shifted(pose, axis, -step));
  const double before = entropy.compute().total;
  entropy.setPose(number, pose);
  return (after - before) / (2 * step);
}

void
expectGradientIsThatOfDifferences(const NaiveEntropySettings& settings)
{
  PosedClouds map = makeRoomViews(3, 3000, 11);
  const auto [x, z, theta] = map.poses[1];
  map.poses[1] = {x + 0.06, z - 0.04, theta + 0.03};
  auto entropy = entropyOf(map, settings);
  std::vector<Eigen::Vector3d> gradient;
  const MapEntropyTerms terms = entropy.computeGradient(gradient);
  EXPECT_TRUE(areSame(terms, entropy.compute()));
  ASSERT_EQ(gradient.size(), 3U);
  double largest = 0;
  for (std::size_t i = 0; i < gradient.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const double wanted = differenceOf(entropy, i, axis, 5e-5);
      EXPECT_NEAR(gradient[i][axis], wanted, 2e-3 * (1 + std::abs(wanted)))
          << "observation " << i << ", axis " << axis;
      largest = std::max(largest, std::abs(wanted));
    }
  EXPECT_GT(largest, 0.1) << "nothing was compared";
}

TEST(Gradient, isThatOfFiniteDifferences)
{
  for (const bool directions : {false, true})
    for (const double mu : {0.0, 0.5})
      for (const double sigma : {0.0, 0.1, 0.23}) {
        SCOPED_TRACE(testing::Message() << "directions " << directions << ", mu " << mu
                                        << ", sigma " << sigma);
        NaiveEntropySettings settings;
        settings.directions = directions;
        settings.mu = mu;
        settings.sigma = sigma;
        expectGradientIsThatOfDifferences(settings);
      }
}

TEST(Gradient, isContinuousWhereACellEntersANewBin)
{
  NaiveEntropySettings settings;
  settings.bin = 0.125;
  settings.sigma = 0.125;
  const PosedClouds map{{cloudAt({{0.5, 0.5}, {0.75, 0.5}}), cloudAt({{0.5, 0.5}})},
                        {{0, 0, 0}, {0, 0, 0}}};
  auto entropy = entropyOf(map, settings);
  std::vector<Eigen::Vector3d> before, at, after;
  entropy.setPose(1, {-1e-9, 0, 0});
  entropy.computeGradient(before);
  entropy.setPose(1, {0, 0, 0});
  entropy.computeGradient(at);
  entropy.setPose(1, {1e-9, 0, 0});
  entropy.computeGradient(after);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((before[i] - at[i]).norm(), 1e-5);
    EXPECT_LT((after[i] - at[i]).norm(), 1e-5);
  }
  EXPECT_GT(at[1].norm(), 0.01);
}

TEST(Gradient, leadsBackToTheTruth)
{
  NaiveEntropySettings settings;
  settings.mu = 0;
  for (const bool directions : {false, true}) {
    settings.directions = directions;
    auto entropy = entropyOf(makeRoomViews(3, 3000, 12), settings);
    const PlanarPose truth = entropy.getPose(1);
    for (const double off : {-0.08, 0.08})
      for (int axis = 0; axis < 3; ++axis) {
        entropy.setPose(1, shifted(truth, axis, off));
        std::vector<Eigen::Vector3d> gradient;
        entropy.computeGradient(gradient);
        EXPECT_GT(gradient[1][axis] * off, 0) << "axis " << axis << ", off by " << off;
      }
  }
}

TEST(Gradient, twoSidesOfAWallAttractEachOtherOnlyWithoutDirections)
{
  NaiveEntropySettings settings;
  settings.mu = 0;
  auto entropy = entropyOf(makeThinWall(0.2), settings);
  std::vector<Eigen::Vector3d> gradient;
  entropy.computeGradient(gradient);
  EXPECT_GT(gradient[1][1], 0.5) << "bits a metre: downhill is towards the other side";
  EXPECT_LT(gradient[0][1], -0.5);
  const double blind = gradient[1][1];
  entropy.setDirectionAware(true);
  entropy.computeGradient(gradient);
  EXPECT_LT(std::abs(gradient[1][1]), 0.1 * blind + 0.2);
}

} // namespace
} // namespace pcl::acmap::test
