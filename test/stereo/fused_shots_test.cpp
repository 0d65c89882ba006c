#include "fusion/fused_shots.h"
#include "tiny_fusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

constexpr std::size_t middle = 40; ///< of nine by nine pixels

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

/** The median of a pixel's disparities: sorted, the lower of two middle ones; NaN if
 * fewer than three were found. */
float
naiveMedian(const std::vector<MatchedDisparity>& maps, std::size_t pixel)
{
  std::vector<float> found;
  for (const MatchedDisparity& map : maps)
    if (!std::isnan(map.disparity.values[pixel]))
      found.push_back(map.disparity.values[pixel]);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t k = i + 1; k < found.size(); ++k)
      if (found[k] < found[i])
        std::swap(found[i], found[k]);
  return found.size() < 3 ? nan : found[(found.size() - 1) / 2];
}

/** Each pattern is matched by itself, then the median of the maps is what the class
 * gives. */
TEST(FusedShots, MedianOfTheMapsIsTheNaiveOne)
{
  for (const int patterns : {3, 4, 9, 10}) {
    DisparityFusion fusion = fusionBy(DisparityFusion::Method::Median);
    TrinocularMatching matching = fusion.getMatching();
    std::vector<MatchedDisparity> maps;
    for (int i = 0; i < patterns; ++i) {
      // The images of the cameras differ in part, so that the maps do; from the third
      // shot on a part has no texture, so that there are fewer than three disparities.
      const TrinocularFrame::Ptr shot = noiseShot(i);
      const CameraImage other = noiseShot(100 + i)->images[0];
      for (std::size_t pixel = 0; pixel < other.values.size(); ++pixel) {
        if ((pixel / 7 + static_cast<std::size_t>(i)) % 5 == 0)
          shot->images[1].values[pixel] = other.values[pixel];
        if (i >= 2 && pixel % 48 < 20)
          for (CameraImage& image : shot->images)
            image.values[pixel] = 90;
      }
      fusion.addShot(shot);
      maps.emplace_back();
      matching.match(*shot, maps.back());
    }
    const MatchedDisparity result = fused(fusion);
    std::size_t several = 0, none = 0;
    for (std::size_t pixel = 0; pixel < result.outcome.size(); ++pixel) {
      const float wanted = naiveMedian(maps, pixel);
      const float found = result.disparity.values[pixel];
      EXPECT_TRUE(found == wanted || (std::isnan(found) && std::isnan(wanted)))
          << patterns << " patterns, pixel " << pixel << ": " << found << ", "
          << wanted;
      several += wanted != maps[0].disparity.values[pixel] && !std::isnan(wanted);
      none += std::isnan(wanted);
    }
    EXPECT_GT(several, 100u);
    EXPECT_GT(none, 10u);
  }
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

/** Nine by nine pixels of disparity 5; the one in the middle has these of its own. */
std::vector<MatchedDisparity>
shotsAround(const std::vector<float>& own)
{
  constexpr int side = 9;
  std::vector<MatchedDisparity> shots;
  for (const float disparity : own) {
    std::vector<float> values(side * side, 5.0f);
    values[middle] = disparity;
    shots.push_back(rowOf(values));
    shots.back().disparity.width = shots.back().disparity.height = side;
  }
  return shots;
}

TEST(FusedShots, FewShotsCountWhereThoseAroundConfirmThem)
{
  const auto shots = shotsAround({5.2f, nan, 5.4f, nan, nan});
  const MatchedDisparity fused = fuseShots(shots, ShotStatistic::ConsistentMean, 3);
  EXPECT_NEAR(fused.disparity.values[middle], 5.3f, 1e-6);
  EXPECT_EQ(fused.support[middle], 2);
  EXPECT_GT(fused.sigma[middle], 0.05f);
  expectNone(fuseShots(shots, ShotStatistic::Median, 3),
             middle,
             DisparityOutcome::TooFewShots);
}

TEST(FusedShots, ShotsAroundDecideBetweenThoseThatDisagree)
{
  const auto shots = shotsAround({33, 4.9f, 12, 5.1f, 26});
  const MatchedDisparity fused = fuseShots(shots, ShotStatistic::ConsistentMean, 3);
  EXPECT_NEAR(fused.disparity.values[middle], 5, 1e-6);
  EXPECT_EQ(fused.support[middle], 2);
}

TEST(FusedShots, ShotsAroundConfirmNoOtherSurface)
{
  const auto expectNoneOf = [](const std::vector<float>& own) {
    const DisparityOutcome why = std::isnan(own[4]) ? DisparityOutcome::TooFewShots
                                                    : DisparityOutcome::Inconsistent;
    expectNone(
        fuseShots(shotsAround(own), ShotStatistic::ConsistentMean, 3), middle, why);
  };
  expectNoneOf({5, nan, nan, nan, nan}); // one alone
  expectNoneOf({8, 8, nan, nan, nan});
  expectNoneOf({5, 12, 19, 26, 33});
}

} // namespace
} // namespace pcl::acmap::test
