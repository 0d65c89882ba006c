#include "painted_views.h"

#include <pcl/core/random.h>
#include <pcl/egomotion/impl/log_polar_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace pcl::acmap::test {
namespace {

using Pairs = std::set<std::pair<std::int32_t, std::int32_t>>;

/** Matches as pixels of both images. */
class LogPolarProperty : public testing::Test {
protected:
  static std::vector<Eigen::Vector3f>
  points(std::size_t size)
  {
    return std::vector<Eigen::Vector3f>(size, Eigen::Vector3f::Zero());
  }

  std::vector<PatchMatch>
  match(const GreyImage& source,
        const std::vector<std::int32_t>& source_pixels,
        const GreyImage& target,
        const std::vector<std::int32_t>& target_pixels)
  {
    return matchPatches(logPolarPatches(source, source_pixels, settings_),
                        logPolarPatches(target, target_pixels, settings_),
                        points(source_pixels.size()),
                        points(target_pixels.size()),
                        gate_,
                        settings_,
                        counts_);
  }

  Pairs
  pixelPairs(const GreyImage& source,
             const std::vector<std::int32_t>& source_pixels,
             const GreyImage& target,
             const std::vector<std::int32_t>& target_pixels)
  {
    Pairs pairs;
    for (const PatchMatch& found : match(source, source_pixels, target, target_pixels))
      pairs.emplace(source_pixels[static_cast<std::size_t>(found.source)],
                    target_pixels[static_cast<std::size_t>(found.target)]);
    return pairs;
  }

  Pairs
  pixelPairs(const GreyImage& source, const GreyImage& target)
  {
    return pixelPairs(source, keypointsOf(source), target, keypointsOf(target));
  }

  /** Numbers of correct and wrong matches between the plain view and a changed one. */
  std::pair<std::size_t, std::size_t>
  judge(const ViewChange& change)
  {
    const GreyImage before = paint(paper_), now = paint(paper_, change);
    std::size_t right = 0, wrong = 0;
    for (const auto& [source, target] : pixelPairs(now, before)) {
      const Eigen::Vector2d wanted = change(placeOf(target, before));
      ++((wanted - placeOf(source, now)).norm() < 2.5 ? right : wrong);
    }
    return {right, wrong};
  }

  const Wallpaper paper_{5};
  LogPolarSettings settings_;
  MatchGate gate_;
  MatchCounts counts_;
};

TEST_F(LogPolarProperty, aShiftedViewIsMatched)
{
  const auto [right, wrong] = judge({0, 1, {7.3, -3.6}});
  EXPECT_GT(right, 100u);
  EXPECT_LE(20 * wrong, right);
}

TEST_F(LogPolarProperty, aTurnIsAShiftOfSectors)
{
  const ViewChange turned{0.5235987756}; // 30 degrees, two sectors
  const std::size_t without = judge(turned).first;
  settings_.sector_shifts = 2;
  const auto [right, wrong] = judge(turned);
  EXPECT_GT(right, 80u);
  EXPECT_LE(20 * wrong, right);
  EXPECT_LT(4 * without, right);
}

TEST_F(LogPolarProperty, aChangeOfScaleIsAShiftOfRings)
{
  settings_.outer = 12;
  for (const double scale : {1.57, 1 / 1.57}) { // two rings
    settings_.ring_shifts = 0;
    const std::size_t without = judge({0, scale}).first;
    settings_.ring_shifts = 2;
    const auto [right, wrong] = judge({0, scale});
    EXPECT_GT(right, 40u) << scale;
    EXPECT_LE(10 * wrong, right) << scale;
    EXPECT_LT(4 * without, right) << scale;
  }
}

TEST_F(LogPolarProperty, gainAndOffsetOfLightChangeNothing)
{
  const GreyImage before = paint(paper_);
  GreyImage now = paint(paper_, {0.05, 1.05, {3, 2}});
  const Pairs wanted = pixelPairs(now, before);
  ASSERT_GT(wanted.size(), 80u);
  for (float& value : now.values)
    value = 0.5F * value + 40; // preserves all maxima in spite of rounding
  EXPECT_EQ(pixelPairs(now, before), wanted);
}

TEST_F(LogPolarProperty, permutedKeypointsGiveTheSameMatches)
{
  const GreyImage before = paint(paper_), now = paint(paper_, {0.05, 1.05, {3, 2}});
  std::vector<std::int32_t> source = keypointsOf(now), target = keypointsOf(before);
  const Pairs wanted = pixelPairs(now, source, before, target);
  ASSERT_GT(wanted.size(), 80u);
  Random random(6);
  for (auto* pixels : {&source, &target})
    for (std::size_t i = pixels->size(); i > 1; --i)
      std::swap((*pixels)[i - 1],
                (*pixels)[static_cast<std::size_t>(
                    random.uniform(0, static_cast<double>(i) - 1e-9))]);
  EXPECT_EQ(pixelPairs(now, source, before, target), wanted);
}

TEST_F(LogPolarProperty, swappedViewsGiveSwappedMatches)
{
  settings_.ring_shifts = 1;
  settings_.sector_shifts = 1;
  const GreyImage before = paint(paper_), now = paint(paper_, {0.1, 1.2, {3, 2}});
  const Pairs wanted = pixelPairs(now, before);
  ASSERT_GT(wanted.size(), 50u);
  Pairs swapped;
  for (const auto& [source, target] : pixelPairs(before, now))
    swapped.emplace(target, source);
  EXPECT_EQ(swapped, wanted);
}

TEST_F(LogPolarProperty, everyNumberOfThreadsGivesTheSameBytes)
{
  const GreyImage before = paint(paper_), now = paint(paper_, {0.05, 1.05, {3, 2}});
  std::vector<std::vector<float>> results;
  for (const unsigned threads : {1U, 2U, 8U}) {
    settings_.threads = threads;
    results.emplace_back();
    for (const PatchMatch& found :
         match(now, keypointsOf(now), before, keypointsOf(before)))
      for (const float value : {static_cast<float>(found.source),
                                static_cast<float>(found.target),
                                found.score,
                                found.ambiguity})
        results.back().push_back(value);
  }
  ASSERT_GT(results[0].size(), 4 * 80u);
  EXPECT_EQ(results[1], results[0]);
  EXPECT_EQ(results[2], results[0]);
}

TEST_F(LogPolarProperty, aRepeatedPatternIsAmbiguous)
{
  // periodic with 48 pixels in both directions
  GreyImage before = paint(paper_);
  for (int y = 0; y < before.height; ++y)
    for (int x = 0; x < before.width; ++x) {
      const auto at = static_cast<std::size_t>(y * before.width + x);
      before.values[at] =
          before.values[static_cast<std::size_t>(y * before.width + x % 48)];
    }
  EXPECT_TRUE(pixelPairs(before, before).empty());
  EXPECT_GT(counts_.ambiguous, 50u);
  gate_.image_distance = 20;
  EXPECT_GT(pixelPairs(before, before).size(), 50u);
}

TEST_F(LogPolarProperty, pairsWithoutAPlacePassOnlyWhereNoDistanceIsAsked)
{
  const GreyImage image = paint(paper_);
  const std::vector<std::int32_t> pixels = keypointsOf(image);
  const LogPolarPatches patches = logPolarPatches(image, pixels, settings_);
  std::vector<Eigen::Vector3f> places = points(pixels.size());
  for (std::size_t i = 0; i < places.size(); i += 2)
    places[i].z() = std::numeric_limits<float>::quiet_NaN();
  const auto count = [&] {
    return matchPatches(patches, patches, places, places, gate_, settings_, counts_)
        .size();
  };
  const std::size_t all = count();
  EXPECT_EQ(all, patches.pixels.size());
  gate_.distance = 1;
  std::size_t with_place = 0;
  for (const std::int32_t keypoint : patches.keypoint)
    with_place += keypoint % 2 == 1;
  EXPECT_EQ(count(), with_place);
}

TEST_F(LogPolarProperty, uglyImagesGiveNoPatches)
{
  GreyImage image = paint(paper_);
  const std::vector<std::int32_t> corners{
      0, 239, 179 * 240, 180 * 240 - 1, 19 * 240 + 100};
  EXPECT_TRUE(logPolarPatches(image, corners, settings_).pixels.empty());
  EXPECT_TRUE(logPolarPatches(image, {}, settings_).pixels.empty());
  const GreyImage small{30, 30, std::vector<float>(900, 5)};
  EXPECT_TRUE(logPolarPatches(small, {15 * 30 + 15}, settings_).pixels.empty());
  const std::int32_t middle = 90 * 240 + 120;
  EXPECT_EQ(logPolarPatches(image, {middle}, settings_).pixels.size(), 1u);
  image.values[static_cast<std::size_t>(middle)] =
      std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(logPolarPatches(image, {middle}, settings_).pixels.empty());
  settings_.min_contrast = 0;
  image.values.assign(image.values.size(), 128);
  const LogPolarPatches none = logPolarPatches(image, {middle}, settings_);
  EXPECT_TRUE(none.pixels.empty());
  EXPECT_TRUE(matchPatches(none, none, {}, {}, gate_, settings_, counts_).empty());
}

} // namespace
} // namespace pcl::acmap::test
