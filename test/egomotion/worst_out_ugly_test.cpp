#include "stereo_matches.h"

#include <pcl/egomotion/impl/worst_out_kernel.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

using Places = std::vector<Eigen::Vector3f>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

void
expectNoneKept(const Places& places)
{
  const WorstOutOutcome outcome = leaveWorstOut(places, places, {});
  EXPECT_TRUE(outcome.kept.empty());
  EXPECT_EQ(outcome.removed.size(), places.size());
  EXPECT_EQ(outcome.distortion, 0);
}

/** Sufficiently far apart. */
Places
cubeCorners()
{
  Places corners;
  for (int corner = 0; corner < 8; ++corner)
    corners.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2);
  return corners;
}

TEST(WorstOutUgly, tooFewMatchesAreNone)
{
  expectNoneKept({});
  expectNoneKept({Eigen::Vector3f(1, 2, 3)});
  Places corners = cubeCorners();
  corners.resize(5);
  expectNoneKept(corners);
}

TEST(WorstOutUgly, matchesInOnePlaceTellNothing)
{
  expectNoneKept(Places(20, Eigen::Vector3f(1, 2, 3)));
  WorstOutSettings settings;
  settings.min_distance = 0;
  const Places places(20, Eigen::Vector3f(1, 2, 3));
  EXPECT_TRUE(leaveWorstOut(places, places, settings).kept.empty());
}

TEST(WorstOutUgly, placesThatAreNotFiniteGoFirst)
{
  Places source = cubeCorners(), target = cubeCorners();
  source.insert(source.begin() + 3, Eigen::Vector3f(0, nan, 0));
  target.insert(target.begin() + 3, Eigen::Vector3f(0, 0, 0));
  source.emplace_back(0, 0, 0);
  target.emplace_back(0, 0, infinity);
  const WorstOutOutcome outcome = leaveWorstOut(source, target, {});
  EXPECT_EQ(outcome.removed, (std::vector<std::int32_t>{3, 9}));
  EXPECT_EQ(outcome.kept, (std::vector<std::int32_t>{0, 1, 2, 4, 5, 6, 7, 8}));
  EXPECT_EQ(outcome.distortion, 1);
  expectNoneKept(Places(20, Eigen::Vector3f(nan, nan, nan)));
}

TEST(WorstOutUgly, squaresThatOverflowDoNotSpoilTheRest)
{
  for (const float far : {1e9F, 1e20F, 1e38F}) {
    Places source = cubeCorners(), target = cubeCorners();
    source.emplace_back(far, 0, 0);
    target.emplace_back(0, -far / 2, 3);
    source.emplace_back(far, -far, far);
    target.emplace_back(0, 0.5F, 0);
    const WorstOutOutcome outcome = leaveWorstOut(source, target, {});
    EXPECT_EQ(outcome.kept.size(), 8u) << far;
    EXPECT_EQ(outcome.distortion, 1) << far;
  }
}

TEST(WorstOutUgly, nearInOneCloudAloneIsAContradiction)
{
  // before, each point is at its own corner; now two of them are at the same one
  const Places source = cubeCorners();
  Places target = cubeCorners();
  target[5] = target[2] + Eigen::Vector3f(0.01F, 0, 0);
  const WorstOutOutcome outcome = leaveWorstOut(source, target, {});
  EXPECT_EQ(outcome.removed, std::vector<std::int32_t>{5});
}

TEST(WorstOutUgly, ofEquallyBadOnesTheFirstGoesFirst)
{
  // both have the same error, as they are mirror images of each other
  Places source = cubeCorners();
  for (const Eigen::Vector3f& corner : cubeCorners())
    source.push_back(corner * 3 - Eigen::Vector3f(1, 1, 1));
  Places target = source;
  source.emplace_back(0.5F, 0.5F, 4);
  target.emplace_back(0.5F, 0.5F, 6);
  source.emplace_back(0.5F, 0.5F, -3);
  target.emplace_back(0.5F, 0.5F, -5);
  const WorstOutOutcome outcome = leaveWorstOut(source, target, {});
  EXPECT_EQ(outcome.removed, (std::vector<std::int32_t>{16, 17}));
}

TEST(WorstOutUgly, aHundredThousandMatchesAreJudged)
{
  StereoMatchSettings scene;
  scene.right = 60000;
  scene.wrong = 40000;
  const StereoMatches matches = stereoMatches(scene);
  const WorstOutOutcome outcome = leaveWorstOut(matches.source, matches.target, {});
  std::size_t right = 0;
  for (const std::int32_t kept : outcome.kept)
    right += matches.is_right[static_cast<std::size_t>(kept)] != 0;
  EXPECT_GT(right, 0.97 * 60000);
  EXPECT_LT(outcome.kept.size() - right, 0.06 * static_cast<double>(right));
}

} // namespace
} // namespace pcl::acmap::test
