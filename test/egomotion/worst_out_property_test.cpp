#include "stereo_matches.h"

#include <pcl/egomotion/impl/worst_out_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace pcl::acmap::test {
namespace {

class WorstOutProperty : public testing::TestWithParam<std::uint64_t> {
protected:
  WorstOutProperty()
  {
    StereoMatchSettings scene;
    scene.right = 120;
    scene.wrong = 100;
    scene.seed = GetParam();
    matches_ = stereoMatches(scene);
    outcome_ = leaveWorstOut(matches_.source, matches_.target, settings_);
  }

  StereoMatches matches_;
  const WorstOutSettings settings_;
  WorstOutOutcome outcome_;
};

TEST_P(WorstOutProperty, swappingTheCloudsChangesNothing)
{
  const WorstOutOutcome swapped =
      leaveWorstOut(matches_.target, matches_.source, settings_);
  EXPECT_EQ(swapped.kept, outcome_.kept);
  EXPECT_EQ(swapped.removed, outcome_.removed);
  EXPECT_EQ(swapped.distortion, outcome_.distortion);
}

TEST_P(WorstOutProperty, theOrderOfMatchesChangesNothing)
{
  std::vector<std::int32_t> order(matches_.source.size());
  std::iota(order.begin(), order.end(), 0);
  Random random(GetParam());
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.bits() % i]);
  StereoMatches shuffled;
  for (const std::int32_t match : order) {
    shuffled.source.push_back(matches_.source[static_cast<std::size_t>(match)]);
    shuffled.target.push_back(matches_.target[static_cast<std::size_t>(match)]);
  }
  WorstOutOutcome outcome = leaveWorstOut(shuffled.source, shuffled.target, settings_);
  for (auto* positions : {&outcome.kept, &outcome.removed})
    for (std::int32_t& position : *positions)
      position = order[static_cast<std::size_t>(position)];
  std::sort(outcome.kept.begin(), outcome.kept.end());
  EXPECT_EQ(outcome.kept, outcome_.kept);
  EXPECT_EQ(outcome.removed, outcome_.removed);
  EXPECT_EQ(outcome.distortion, outcome_.distortion);
}

TEST_P(WorstOutProperty, movingEitherCloudChangesNothing)
{
  Random random(GetParam());
  const Eigen::Isometry3f motion = anyMotion(random).cast<float>();
  for (auto* cloud : {&matches_.source, &matches_.target}) {
    for (Eigen::Vector3f& place : *cloud)
      place = motion * place;
    const WorstOutOutcome moved =
        leaveWorstOut(matches_.source, matches_.target, settings_);
    EXPECT_EQ(moved.kept, outcome_.kept);
    EXPECT_EQ(moved.removed, outcome_.removed);
    EXPECT_NEAR(moved.distortion, outcome_.distortion, 1e-5);
  }
}

TEST_P(WorstOutProperty, aCommonScaleChangesNothing)
{
  for (auto* cloud : {&matches_.source, &matches_.target})
    for (Eigen::Vector3f& place : *cloud)
      place *= 8;
  WorstOutSettings scaled = settings_;
  scaled.min_distance *= 8;
  const WorstOutOutcome outcome =
      leaveWorstOut(matches_.source, matches_.target, scaled);
  EXPECT_EQ(outcome.kept, outcome_.kept);
  EXPECT_EQ(outcome.removed, outcome_.removed);
  EXPECT_EQ(outcome.distortion, outcome_.distortion);
}

TEST_P(WorstOutProperty, keptAndRemovedAreAllAndEachOnce)
{
  std::vector<std::int32_t> all = outcome_.kept;
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  all.insert(all.end(), outcome_.removed.begin(), outcome_.removed.end());
  std::sort(all.begin(), all.end());
  std::vector<std::int32_t> wanted(matches_.source.size());
  std::iota(wanted.begin(), wanted.end(), 0);
  EXPECT_EQ(all, wanted);
}

INSTANTIATE_TEST_SUITE_P(Seeds, WorstOutProperty, testing::Range<std::uint64_t>(1, 6));

} // namespace
} // namespace pcl::acmap::test
