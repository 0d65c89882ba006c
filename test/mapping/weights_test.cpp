#include "entropy_runs.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

using Weights = std::vector<std::vector<float>>;

/** Integers from 0 to 3. */
Weights
smallWeights(const PosedClouds& map)
{
  Random random(31);
  Weights weights;
  for (const auto& cloud : map.clouds) {
    weights.emplace_back();
    for (std::size_t i = 0; i < cloud->size(); ++i)
      weights.back().push_back(static_cast<float>(std::floor(random.uniform(0, 4))));
  }
  return weights;
}

MapEntropy<PointNormal>
weighted(const PosedClouds& map, const Weights& weights, bool directions)
{
  NaiveEntropySettings settings;
  settings.directions = directions;
  auto entropy = entropyOf({}, settings);
  for (std::size_t i = 0; i < map.clouds.size(); ++i)
    entropy.addPointCloud(map.clouds[i], map.poses[i], weights[i]);
  return entropy;
}

/** Repeats each point as often as its weight says. */
PosedClouds
repeated(PosedClouds map, const Weights& weights)
{
  for (std::size_t i = 0; i < map.clouds.size(); ++i) {
    PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
    for (std::size_t p = 0; p < weights[i].size(); ++p)
      for (int times = 0; times < static_cast<int>(weights[i][p]); ++times)
        cloud->push_back((*map.clouds[i])[p]);
    map.clouds[i] = cloud;
  }
  return map;
}

void
expectNear(const MapEntropyTerms& terms, const MapEntropyTerms& wanted, double rounding)
{
  EXPECT_NEAR(terms.total, wanted.total, rounding);
  EXPECT_NEAR(terms.joint, wanted.joint, rounding);
  EXPECT_NEAR(terms.along_x, wanted.along_x, rounding);
  EXPECT_NEAR(terms.along_z, wanted.along_z, rounding);
}

TEST(MapEntropyWeights, pointsCountAsOftenAsTheyWeigh)
{
  const PosedClouds map = makeRoomViews(3, 1500, 32);
  const Weights weights = smallWeights(map);
  for (const bool directions : {false, true}) {
    NaiveEntropySettings settings;
    settings.directions = directions;
    auto plain = entropyOf(repeated(map, weights), settings);
    auto entropy = weighted(map, weights, directions);
    std::vector<Eigen::Vector3d> wanted, gradient;
    expectNear(entropy.computeGradient(gradient), plain.computeGradient(wanted), 1e-9);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_LT((gradient[i] - wanted[i]).norm(), 1e-8 * (1 + wanted[i].norm()));
    expectNear(entropy.computeExact(), plain.computeExact(), 1e-9);
    EXPECT_EQ(entropy.computeExact().points, 4500U) << "a count, whatever they weigh";
    EXPECT_EQ(entropy.compute().points, 4500U);
    EXPECT_GT(
        std::abs(entropy.compute().total - entropyOf(map, settings).compute().total),
        1e-3);
  }
}

TEST(MapEntropyWeights, onesAreAsNone)
{
  const PosedClouds map = makeRoomViews(2, 800, 33);
  auto ones = weighted(map, Weights(2, std::vector<float>(800, 1)), true);
  auto none = weighted(map, Weights(2), true);
  std::vector<Eigen::Vector3d> gradient, wanted;
  EXPECT_TRUE(areSame(ones.computeGradient(gradient), none.computeGradient(wanted)));
  EXPECT_EQ(gradient, wanted);
  EXPECT_TRUE(areSame(ones.computeExact(), none.computeExact()));
}

TEST(MapEntropyWeights, theirUnitPlaysNoRole)
{
  const PosedClouds map = makeRoomViews(2, 800, 34);
  Weights weights = smallWeights(map);
  const MapEntropyTerms terms = weighted(map, weights, false).compute();
  const MapEntropyTerms exact = weighted(map, weights, false).computeExact();
  for (const float unit : {0x1p-60F, 0x1p90F}) {
    Weights scaled = weights;
    for (auto& of_cloud : scaled)
      for (float& weight : of_cloud)
        weight *= unit;
    expectNear(weighted(map, scaled, false).compute(), terms, 1e-9);
    expectNear(weighted(map, scaled, false).computeExact(), exact, 1e-9);
  }
}

TEST(MapEntropyWeights, badOnesAreRefusedByTheirPoint)
{
  const PosedClouds map = makeRoomViews(1, 10, 35);
  MapEntropy<PointNormal> entropy;
  for (const float bad : {-1.0F,
                          std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity()}) {
    std::vector<float> weights(10, 1);
    weights[7] = bad;
    EXPECT_THAT([&] { entropy.addPointCloud(map.clouds[0], {}, weights); },
                testing::ThrowsMessage<BadArgumentException>(
                    testing::HasSubstr("weight of point 7")))
        << bad << " was taken";
  }
  EXPECT_THROW(entropy.addPointCloud(map.clouds[0], {}, std::vector<float>(9, 1)),
               BadArgumentException);
  EXPECT_EQ(entropy.getNumberOfPointClouds(), 0U);
}

TEST(MapEntropyWeights, withoutAnyThereIsNoEntropy)
{
  const PosedClouds map = makeRoomViews(2, 50, 36);
  auto entropy = weighted(map, Weights(2, std::vector<float>(50, 0)), false);
  for (const MapEntropyTerms& terms : {entropy.compute(), entropy.computeExact()}) {
    EXPECT_TRUE(areSame(terms, {}));
    ASSERT_FALSE(entropy.getReport().remarks.empty());
    EXPECT_EQ(entropy.getReport().remarks[0], "no point has a weight: no entropy");
  }
}

} // namespace
} // namespace pcl::acmap::test
