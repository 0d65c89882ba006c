#include "stereo_matches.h"

#include <pcl/egomotion/impl/worst_out_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Relative error of ratios of float distances. */
constexpr double rounding = 2e-6;

/** Eq. 1 for one match as in the paper, computed from all others. */
double
naiveDistortion(std::int32_t match,
                const std::vector<std::int32_t>& others,
                const StereoMatches& matches,
                double minimum)
{
  const auto at = [](const std::vector<Eigen::Vector3f>& places, std::int32_t k) {
    return places[static_cast<std::size_t>(k)].cast<double>().eval();
  };
  double sum = 0;
  int count = 0;
  for (const std::int32_t other : others) {
    const double a = (at(matches.source, match) - at(matches.source, other)).norm();
    const double b = (at(matches.target, match) - at(matches.target, other)).norm();
    if (other == match || std::max(a, b) <= minimum)
      continue;
    const double ratio = std::max(a, minimum) / std::max(b, minimum);
    sum += std::max(ratio, 1 / ratio);
    ++count;
  }
  return count ? sum / count : std::numeric_limits<double>::infinity();
}

double
naiveWorst(const std::vector<std::int32_t>& left,
           const StereoMatches& matches,
           double minimum)
{
  double worst = 0;
  for (const std::int32_t match : left)
    worst = std::max(worst, naiveDistortion(match, left, matches, minimum));
  return worst;
}

/** Parameters: number of wrong matches, minimum distance. */
class WorstOutOracle : public testing::TestWithParam<std::tuple<std::size_t, double>> {
};

TEST_P(WorstOutOracle, everyRemovalIsOfTheWorstAndNoneTooMany)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    StereoMatchSettings scene;
    scene.wrong = std::get<0>(GetParam());
    scene.right = 60 - scene.wrong;
    scene.seed = seed;
    const StereoMatches matches = stereoMatches(scene);
    WorstOutSettings settings;
    settings.min_distance = std::get<1>(GetParam());
    const WorstOutOutcome outcome =
        leaveWorstOut(matches.source, matches.target, settings);

    std::vector<std::int32_t> left(matches.source.size());
    for (std::size_t i = 0; i < left.size(); ++i)
      left[i] = static_cast<std::int32_t>(i);
    for (const std::int32_t removed : outcome.removed) {
      const double worst = naiveWorst(left, matches, settings.min_distance);
      EXPECT_GT(worst, settings.max_distortion - rounding);
      EXPECT_NEAR(naiveDistortion(removed, left, matches, settings.min_distance),
                  worst,
                  rounding * worst);
      left.erase(std::find(left.begin(), left.end(), removed));
    }
    EXPECT_EQ(outcome.kept, left);
    EXPECT_NEAR(
        outcome.distortion, naiveWorst(left, matches, settings.min_distance), rounding);
    EXPECT_LE(outcome.distortion, settings.max_distortion);
  }
}

INSTANTIATE_TEST_SUITE_P(
    WrongAndLeast,
    WorstOutOracle, // with 1 m, many pairs are near in one or both clouds
    testing::Combine(testing::Values(0, 6, 20, 36), testing::Values(0.0, 0.05, 1.0)));

/** Eq. 1 as printed: the sum over all matches, divided by their number. */
double
printedDistortion(std::int32_t match,
                  const std::vector<std::int32_t>& all,
                  const StereoMatches& matches)
{
  double sum = 0;
  for (const std::int32_t other : all) {
    const auto i = static_cast<std::size_t>(match), k = static_cast<std::size_t>(other);
    const double a = (matches.source[i] - matches.source[k]).cast<double>().norm();
    const double b = (matches.target[i] - matches.target[k]).cast<double>().norm();
    sum += a == b ? 1 : std::min(std::max(a / b, b / a), 1000.0);
  }
  return sum / static_cast<double>(all.size());
}

TEST(WorstOutAsPrinted, isTheSumOverAllMatchesByTheirNumber)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    StereoMatchSettings scene;
    scene.right = 40;
    scene.wrong = 25;
    scene.seed = seed;
    StereoMatches matches = stereoMatches(scene);
    matches.source[7] = matches.source[20];  // a distance of 0 in one cloud
    matches.source[30] = matches.source[31]; // and in both
    matches.target[30] = matches.target[31];
    WorstOutSettings settings;
    settings.paper = true;
    settings.max_distortion = 1.1;
    settings.sample = 10; // neither of these has an effect
    settings.min_distance = 1;
    settings.min_matches = 1000;
    const WorstOutOutcome outcome =
        leaveWorstOut(matches.source, matches.target, settings);

    std::vector<std::int32_t> left(matches.source.size());
    for (std::size_t i = 0; i < left.size(); ++i)
      left[i] = static_cast<std::int32_t>(i);
    const auto worst = [&] {
      double maximum = 0;
      for (const std::int32_t match : left)
        maximum = std::max(maximum, printedDistortion(match, left, matches));
      return maximum;
    };
    ASSERT_GE(outcome.removed.size(), 20u);
    for (const std::int32_t removed : outcome.removed) {
      EXPECT_GT(worst(), settings.max_distortion - rounding);
      EXPECT_NEAR(
          printedDistortion(removed, left, matches), worst(), rounding * worst());
      left.erase(std::find(left.begin(), left.end(), removed));
    }
    EXPECT_EQ(outcome.kept, left);
    EXPECT_LE(worst(), settings.max_distortion + rounding);
    EXPECT_NEAR(outcome.distortion, worst(), rounding);
  }
}

TEST(WorstOutAsPrinted, perfectMatchesHaveADistortionOfOne)
{
  WorstOutSettings settings;
  settings.paper = true;
  const std::vector<Eigen::Vector3f> places = {{0, 0, 1}, {1, 0, 2}, {1, 0, 2}};
  const WorstOutOutcome outcome = leaveWorstOut(places, places, settings);
  EXPECT_EQ(outcome.kept, (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(outcome.distortion, 1);
  EXPECT_EQ(leaveWorstOut({places[0]}, {places[1]}, settings).kept.size(), 1u);
  EXPECT_TRUE(leaveWorstOut({}, {}, settings).kept.empty());
}

TEST(WorstOutSample, othersAreJudgedByWhatIsLeftOfIt)
{
  StereoMatchSettings scene;
  scene.right = 300;
  scene.wrong = 200;
  const StereoMatches matches = stereoMatches(scene);
  WorstOutSettings settings;
  settings.sample = 100;
  const WorstOutOutcome outcome =
      leaveWorstOut(matches.source, matches.target, settings);

  // every fifth of 500
  std::vector<std::int32_t> sample;
  for (const std::int32_t kept : outcome.kept)
    if (kept % 5 == 4)
      sample.push_back(kept);
  ASSERT_GT(sample.size(), 40u);
  EXPECT_LE(naiveWorst(sample, matches, settings.min_distance),
            settings.max_distortion + rounding);
  for (std::int32_t match = 0; match < 500; ++match) {
    if (match % 5 == 4)
      continue;
    const bool is_kept =
        std::binary_search(outcome.kept.begin(), outcome.kept.end(), match);
    const double distortion =
        naiveDistortion(match, sample, matches, settings.min_distance);
    EXPECT_EQ(is_kept, distortion <= settings.max_distortion) << match;
  }
}

} // namespace
} // namespace pcl::acmap::test
