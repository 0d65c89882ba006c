#include "fusion/shot_statistics.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::acmap::test {
namespace {

using Shots = std::vector<ShotDisparity>;
using Statistic = FusedDisparity (*)(const ShotDisparity*, const ShotDisparity*);

FusedDisparity
fused(Statistic statistic, Shots shots)
{
  sortShots(shots.data(), shots.data() + shots.size());
  return statistic(shots.data(), shots.data() + shots.size());
}

Shots
shotsAt(const std::vector<float>& disparities, float sigma = 0.1f)
{
  Shots shots;
  for (const float disparity : disparities)
    shots.push_back({disparity, sigma});
  return shots;
}

/** Gaussian errors whose sigmas differ by a factor of up to 8. With a scale other than
 * 1 the sigmas of the shots are wrong. */
Shots
normalShots(Random& random, std::size_t count, double scale)
{
  Shots shots;
  for (std::size_t i = 0; i < count; ++i) {
    const double sigma = random.uniform(0.05, 0.4);
    shots.push_back({static_cast<float>(20.0 + scale * sigma * random.normal()),
                     static_cast<float>(sigma)});
  }
  return shots;
}

void
expectSame(const FusedDisparity& a, const FusedDisparity& b)
{
  EXPECT_EQ(a.disparity, b.disparity);
  EXPECT_EQ(a.sigma, b.sigma);
  EXPECT_EQ(a.support, b.support);
  EXPECT_EQ(a.is_consistent, b.is_consistent);
}

TEST(ShotStatistics, MedianIsTheLowerOfTwoMiddleOnes)
{
  EXPECT_EQ(fused(medianOfShots, shotsAt({7})).disparity, 7);
  EXPECT_EQ(fused(medianOfShots, shotsAt({9, 7})).disparity, 7);
  EXPECT_EQ(fused(medianOfShots, shotsAt({9, 30, 7})).disparity, 9);
  const FusedDisparity of_four = fused(medianOfShots, shotsAt({9, 30, 7, 8}));
  EXPECT_EQ(of_four.disparity, 8);
  EXPECT_EQ(of_four.support, 4);
  EXPECT_TRUE(of_four.is_consistent);
}

TEST(ShotStatistics, OrderOfShotsChangesNoByte)
{
  Random random(1);
  for (const Statistic statistic : {medianOfShots, consistentMeanOfShots})
    for (std::size_t count = 1; count < 12; ++count) {
      Shots shots = normalShots(random, count, 2.0);
      shots.front().disparity = shots.back().disparity; // equal disparities with
                                                        // different sigmas
      const FusedDisparity wanted = fused(statistic, shots);
      std::reverse(shots.begin(), shots.end());
      expectSame(fused(statistic, shots), wanted);
      std::rotate(shots.begin(), shots.begin() + count / 2, shots.end());
      expectSame(fused(statistic, shots), wanted);
    }
}

/** Straightforward implementation with sorted copies, in double precision. */
double
plainMeanOfInliers(const Shots& shots, std::size_t& support)
{
  const auto lowerMedian = [](std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[(values.size() - 1) / 2];
  };
  std::vector<double> values, deviations;
  for (const ShotDisparity& shot : shots)
    values.push_back(shot.disparity);
  const double median = lowerMedian(values);
  for (const double value : values)
    deviations.push_back(std::abs(value - median));
  const double limit = std::max(3 * 1.4826 * lowerMedian(deviations), 1.0);
  double sum = 0, weights = 0;
  support = 0;
  for (const ShotDisparity& shot : shots)
    if (std::abs(shot.disparity - median) <= limit) {
      const double weight = 1 / (shot.sigma * shot.sigma + 0.05 * 0.05);
      sum += weight * shot.disparity;
      weights += weight;
      ++support;
    }
  return sum / weights;
}

TEST(ShotStatistics, MeanIsThatOfInliersByTheirVariances)
{
  Random random(2);
  for (int round = 0; round < 2000; ++round) {
    Shots shots = normalShots(random, 1 + random.bits() % 12, 3.0);
    for (ShotDisparity& shot : shots)
      if (random.uniform() < 0.3)
        shot.disparity = static_cast<float>(random.uniform(0, 64));
    std::size_t support = 0;
    const double mean = plainMeanOfInliers(shots, support);
    const FusedDisparity result = fused(consistentMeanOfShots, shots);
    EXPECT_NEAR(result.disparity, mean, 1e-4);
    EXPECT_EQ(result.support, support);
  }
}

TEST(ShotStatistics, OutliersNeitherMoveTheMeanNorSpoilIt)
{
  const FusedDisparity result = fused(
      consistentMeanOfShots, shotsAt({20.1f, 19.9f, 20, 20.1f, 19.9f, 20, 3, 55, 41}));
  EXPECT_TRUE(result.is_consistent);
  EXPECT_EQ(result.support, 6);
  EXPECT_NEAR(result.disparity, 20, 1e-5);
  EXPECT_LT(result.sigma, 0.1);
}

TEST(ShotStatistics, ShotsThatTellDifferentDisparitiesAreInconsistent)
{
  const auto isConsistent = [](const std::vector<float>& disparities) {
    return fused(consistentMeanOfShots, shotsAt(disparities)).is_consistent;
  };
  EXPECT_FALSE(isConsistent({3, 10, 17, 25, 33, 41, 50, 58, 60})); // noise
  EXPECT_FALSE(isConsistent({10, 10, 10, 10, 20, 20, 20, 20}));    // two surfaces
  EXPECT_FALSE(
      isConsistent({10, 10.95f, 9.05f, 10.95f, 9.05f, 11.3f, 8.7f})); // outliers
  EXPECT_TRUE(isConsistent({10, 10, 10, 10, 10, 20, 20, 20}));
  EXPECT_TRUE(isConsistent({10, 10.3f, 9.8f, 10.2f, 9.7f, 10.1f, 9.9f}));
  EXPECT_TRUE(isConsistent({10}));
}

TEST(ShotStatistics, HonestShotsAreSeldomInconsistent)
{
  Random random(3);
  int rejected = 0;
  for (int round = 0; round < 5000; ++round)
    rejected += !fused(consistentMeanOfShots, normalShots(random, 10, 1)).is_consistent;
  EXPECT_LT(rejected, 50); // the significance level of 1 %
}

/** RMS of the errors in units of sigma. */
double
errorInSigmas(Statistic statistic, std::size_t count, double scale)
{
  Random random(4);
  double sum = 0;
  constexpr int rounds = 4000;
  for (int round = 0; round < rounds; ++round) {
    const FusedDisparity result = fused(statistic, normalShots(random, count, scale));
    const double error = (result.disparity - 20.0) / result.sigma;
    sum += error * error;
  }
  return std::sqrt(sum / rounds);
}

TEST(ShotStatistics, SigmaIsThatOfTheErrorsAlsoWhenTheShotsAreWrongAboutThem)
{
  for (const std::size_t count : {5, 10, 30})
    for (const double scale : {0.5, 1.0, 1.5}) {
      SCOPED_TRACE(std::to_string(count) + " shots, scale " + std::to_string(scale));
      for (const Statistic statistic : {medianOfShots, consistentMeanOfShots}) {
        const double error = errorInSigmas(statistic, count, scale);
        EXPECT_GT(error, 0.5); // sigma of many shots includes common errors, which are
                               // absent here
        EXPECT_LT(error, 1.5);
      }
    }
}

TEST(ShotStatistics, SigmaOfManyShotsDoesNotFallWithoutEnd)
{
  const Shots shots = shotsAt(std::vector<float>(256, 20.0f), 0.3f);
  for (const Statistic statistic : {medianOfShots, consistentMeanOfShots}) {
    const float sigma = fused(statistic, shots).sigma;
    EXPECT_GE(sigma, 0.005f);
    EXPECT_LT(sigma, 0.1f);
  }
}

TEST(ShotStatistics, ChiSquareLimitIsThatOfTables)
{
  EXPECT_NEAR(chiSquareLimit(1), 6.635, 0.07);
  EXPECT_NEAR(chiSquareLimit(2), 9.210, 0.05);
  EXPECT_NEAR(chiSquareLimit(9), 21.666, 0.05);
  EXPECT_NEAR(chiSquareLimit(100), 135.807, 0.05);
  EXPECT_TRUE(std::isinf(chiSquareLimit(0)));
}

} // namespace
} // namespace pcl::acmap::test
