#include "fusion/fused_shots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** One row of pixels; NaN: not matched, for the given reason. */
MatchedDisparity
rowOf(const std::vector<float>& disparities,
      DisparityOutcome why = DisparityOutcome::Untextured)
{
  MatchedDisparity row = noDisparity(static_cast<int>(disparities.size()), 1, why);
  for (std::size_t i = 0; i < disparities.size(); ++i)
    if (!std::isnan(disparities[i])) {
      row.disparity.values[i] = disparities[i];
      row.sigma[i] = 0.1f;
      row.outcome[i] = DisparityOutcome::Matched;
    }
  return row;
}

void
expectNone(const MatchedDisparity& fused, std::size_t pixel, DisparityOutcome why)
{
  EXPECT_TRUE(std::isnan(fused.disparity.values[pixel]));
  EXPECT_TRUE(std::isnan(fused.sigma[pixel]));
  EXPECT_EQ(fused.support[pixel], 0);
  EXPECT_EQ(fused.outcome[pixel], why);
}

TEST(FusedShots, PixelNeedsEnoughShots)
{
  const std::vector<MatchedDisparity> shots = {rowOf({5, 5, 5, 5}),
                                               rowOf({nan, 6, 6, 6}),
                                               rowOf({nan, nan, 7, 7}),
                                               rowOf({nan, nan, nan, 8})};
  for (const auto statistic : {ShotStatistic::Median, ShotStatistic::ConsistentMean})
    expectNone(fuseShots(shots, statistic, 3), 0, DisparityOutcome::TooFewShots);
  const MatchedDisparity median = fuseShots(shots, ShotStatistic::Median, 3);
  expectNone(median, 1, DisparityOutcome::TooFewShots);
  EXPECT_EQ(median.disparity.values[2], 6);
  EXPECT_EQ(median.disparity.values[3], 6);
  EXPECT_EQ(median.support, (std::vector<std::uint16_t>{0, 0, 3, 4}));
  EXPECT_GT(median.sigma[3], 0);
}

TEST(FusedShots, SupportOfTheMeanIsItsInliers)
{
  const std::vector<MatchedDisparity> shots = {
      rowOf({5, 5}), rowOf({5, 5}), rowOf({5, 5}), rowOf({30, 5})};
  const MatchedDisparity fused = fuseShots(shots, ShotStatistic::ConsistentMean, 3);
  EXPECT_EQ(fused.support, (std::vector<std::uint16_t>{3, 4}));
  expectNone(fuseShots(shots, ShotStatistic::ConsistentMean, 4),
             0,
             DisparityOutcome::TooFewShots);
}

TEST(FusedShots, PixelWithoutAnyDisparityTellsTheCommonestReason)
{
  const std::vector<MatchedDisparity> shots = {
      rowOf({nan}, DisparityOutcome::OneSided),
      rowOf({nan}, DisparityOutcome::Uncorrelated),
      rowOf({nan}, DisparityOutcome::OneSided)};
  for (const auto statistic : {ShotStatistic::Median, ShotStatistic::ConsistentMean})
    expectNone(fuseShots(shots, statistic, 1), 0, DisparityOutcome::OneSided);
}

TEST(FusedShots, ShotsThatDisagreeAreToldButByTheMedian)
{
  std::vector<MatchedDisparity> shots;
  for (const float disparity : {4.0f, 11.0f, 19.0f, 26.0f, 33.0f})
    shots.push_back(rowOf({disparity}));
  expectNone(fuseShots(shots, ShotStatistic::ConsistentMean, 3),
             0,
             DisparityOutcome::Inconsistent);
  EXPECT_EQ(fuseShots(shots, ShotStatistic::Median, 3).disparity.values[0], 19);
}

} // namespace
} // namespace pcl::acmap::test
