#include "matched_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace pcl::acmap::test {

namespace {

template <typename Value>
bool
sameBytes(const std::vector<Value>& a, const std::vector<Value>& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

double
quantile(std::vector<double> values, double share)
{
  if (values.empty())
    return 0;
  const auto at =
      static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(
      values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

void
expectSound(const MatchedDisparity& matched,
            const TrinocularMatching& matching,
            std::size_t shots)
{
  const TrinocularRig& rig = matching.getInputRig();
  const bool has_both = rig.baseline_horizontal != 0 && rig.baseline_vertical != 0;
  const double pixel = // for the pair with the shorter baseline
      has_both
          ? std::max(1.0, std::abs(rig.baseline_horizontal / rig.baseline_vertical))
          : 1.0;
  const double minimum = matching.getXOffset() - 2 * pixel;
  const double maximum = matching.getXOffset() + matching.getMaxDisparity() + 2 * pixel;
  const auto pixels =
      static_cast<std::size_t>(rig.width) * static_cast<std::size_t>(rig.height);
  EXPECT_EQ(matched.disparity.width, rig.width);
  EXPECT_EQ(matched.disparity.height, rig.height);
  ASSERT_EQ(matched.disparity.values.size(), pixels);
  ASSERT_EQ(matched.sigma.size(), pixels);
  ASSERT_EQ(matched.support.size(), pixels);
  ASSERT_EQ(matched.outcome.size(), pixels);
  std::size_t faults = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto d = static_cast<double>(matched.disparity.values[i]);
    const auto sigma = static_cast<double>(matched.sigma[i]);
    const bool is_whole = d > minimum && d < maximum && sigma > 0 &&
                          std::isfinite(matched.sigma[i]) && matched.support[i] >= 1 &&
                          matched.support[i] <= shots;
    const bool is_void = std::isnan(d) && std::isnan(sigma) &&
                         matched.support[i] == 0 &&
                         matched.outcome[i] < DisparityOutcome::TooFewShots;
    faults += matched.outcome[i] == DisparityOutcome::Matched ? !is_whole : !is_void;
  }
  EXPECT_EQ(faults, 0u) << "pixels whose members contradict each other";
  const TrinocularMatchingReport report = matching.getReport();
  EXPECT_EQ(report.outcomes, countOutcomes(matched));
  EXPECT_EQ(
      std::accumulate(report.outcomes.begin(), report.outcomes.end(), std::size_t{0}),
      pixels);
  EXPECT_LE(report.by_both_pairs, report.outcomes[0]);
  EXPECT_EQ(report.shots, shots);
}

} // namespace

MatchErrors
errorsOf(const MatchedDisparity& matched, const DisparityImage& truth)
{
  MatchErrors errors;
  std::vector<double> found;
  std::size_t bad = 0, beyond = 0;
  double squares = 0;
  for (std::size_t i = 0; i < truth.values.size(); ++i) {
    if (std::isnan(truth.values[i]))
      continue;
    ++errors.pixels;
    if (matched.outcome[i] != DisparityOutcome::Matched)
      continue;
    const double error = static_cast<double>(matched.disparity.values[i]) -
                         static_cast<double>(truth.values[i]);
    found.push_back(std::abs(error));
    bad += std::abs(error) > 1;
    const double in_sigma = error / static_cast<double>(matched.sigma[i]);
    if (std::abs(in_sigma) > 5)
      ++beyond;
    else
      squares += in_sigma * in_sigma;
  }
  const auto pixels = static_cast<double>(errors.pixels);
  errors.missing = 1 - static_cast<double>(found.size()) / pixels;
  errors.bad = static_cast<double>(bad) / pixels;
  const auto matched_pixels = static_cast<double>(found.size());
  errors.beyond = static_cast<double>(beyond) / matched_pixels;
  errors.rms_in_sigma =
      std::sqrt(squares / (matched_pixels - static_cast<double>(beyond)));
  errors.median = quantile(std::move(found), 0.5);
  return errors;
}

double
shareMatched(const MatchedDisparity& matched)
{
  return static_cast<double>(countOutcomes(matched)[0]) /
         static_cast<double>(matched.outcome.size());
}

bool
isSame(const MatchedDisparity& a, const MatchedDisparity& b)
{
  return a.disparity.width == b.disparity.width &&
         a.disparity.height == b.disparity.height &&
         sameBytes(a.disparity.values, b.disparity.values) &&
         sameBytes(a.sigma, b.sigma) && sameBytes(a.support, b.support) &&
         sameBytes(a.outcome, b.outcome);
}

Likeness
likenessOf(const MatchedDisparity& a, const MatchedDisparity& b)
{
  std::size_t same = 0;
  std::vector<double> apart;
  for (std::size_t i = 0; i < a.outcome.size(); ++i) {
    same += a.outcome[i] == b.outcome[i];
    if (a.outcome[i] == DisparityOutcome::Matched && a.outcome[i] == b.outcome[i])
      apart.push_back(std::abs(static_cast<double>(a.disparity.values[i]) -
                               static_cast<double>(b.disparity.values[i])));
  }
  const auto pixels = static_cast<double>(a.outcome.size());
  const auto matched = static_cast<double>(apart.size());
  return {static_cast<double>(same) / pixels,
          matched / pixels,
          quantile(std::move(apart), 0.99)};
}

MatchedDisparity
matchSoundly(TrinocularMatching& matching,
             const std::vector<TrinocularFrame::Ptr>& shots)
{
  MatchedDisparity matched;
  matching.match({shots.begin(), shots.end()}, matched);
  expectSound(matched, matching, shots.size());
  return matched;
}

MatchedDisparity
matchSoundly(const TrinocularRig& rig, const std::vector<TrinocularFrame::Ptr>& shots)
{
  TrinocularMatching matching;
  matching.setInputRig(rig);
  matching.setMaxDisparity(32);
  return matchSoundly(matching, shots);
}

} // namespace pcl::acmap::test
