#include "matched_checks.h"
#include "synthetic_shots.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using Outcome = DisparityOutcome;

TrinocularMatching
matchingOf(const TrinocularRig& rig)
{
  TrinocularMatching matching;
  matching.setInputRig(rig);
  matching.setMaxDisparity(32);
  return matching;
}

/** Fraction of an outcome among the pixels in [left, right) x [top, bottom). */
struct Area {
  int left, right, top, bottom;

  double
  shareOf(const MatchedDisparity& matched, Outcome outcome) const
  {
    int count = 0;
    for (int row = top; row < bottom; ++row)
      for (int column = left; column < right; ++column)
        count += at(matched, column, row) == outcome;
    return count / static_cast<double>((right - left) * (bottom - top));
  }

  static Outcome
  at(const MatchedDisparity& matched, int column, int row)
  {
    return matched
        .outcome[static_cast<std::size_t>(row * matched.disparity.width + column)];
  }
};

constexpr Area inner{30, 80, 20, 60};

/** A rectangle at 15 px in front of a wall at 5 px. */
SyntheticScene
sceneWithSheet(const TrinocularRig& rig)
{
  SyntheticScene scene = flatScene(rig, 5);
  scene.sheets.insert(
      scene.sheets.begin(),
      {[](double, double) { return 15.0; },
       [](int shot, double x, double y) { return noiseLevel(shot + 100, x, y); },
       [](double x, double y) { return x >= 40 && x < 70 && y >= 20 && y < 65; }});
  return scene;
}

// right of the rectangle the wall is occluded in the left camera
constexpr Area hidden{72, 79, 24, 60};

TEST(TrinocularMatchingMasks, LeftRightCheckRefusesWhatANeighbourDoesNotSee)
{
  const TrinocularRig pair = syntheticRig(-0.1, 0);
  const auto shots = shotsOf(sceneWithSheet(pair), 5);
  TrinocularMatching matching = matchingOf(pair);
  const MatchedDisparity tested = matchSoundly(matching, shots);
  EXPECT_LT(hidden.shareOf(tested, Outcome::Matched), 0.1);
  const DisparityImage truth = trueDisparities(sceneWithSheet(pair));
  EXPECT_LT(errorsOf(tested, truth).missing, 0.05);
  EXPECT_LT(errorsOf(tested, truth).bad, 0.02);

  matching.setCorrelationThreshold(-1);
  EXPECT_GT(hidden.shareOf(matchSoundly(matching, shots), Outcome::OneSided), 0.8);
  matching.setLeftRightCheck(false);
  const MatchedDisparity unchecked = matchSoundly(matching, shots);
  EXPECT_GT(hidden.shareOf(unchecked, Outcome::Matched), 0.9);
  EXPECT_EQ(countOutcomes(unchecked)[static_cast<std::size_t>(Outcome::OneSided)], 0u);
}

TEST(TrinocularMatchingMasks, TheOtherPairSeesWhatIsHiddenFromOne)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  const SyntheticScene scene = sceneWithSheet(rig);
  const MatchedDisparity matched = matchSoundly(rig, shotsOf(scene, 5));
  const MatchErrors errors =
      errorsOf(matched, trueDisparities(scene, [](int column, int row) {
                 return column >= hidden.left && column < hidden.right &&
                        row >= hidden.top && row < hidden.bottom;
               }));
  EXPECT_LT(errors.missing, 0.05);
  EXPECT_LT(errors.bad, 0.02);
}

/** A texture that is periodic with 8 px in each row. */
SyntheticScene
periodicScene(const TrinocularRig& rig)
{
  SyntheticScene scene = flatScene(rig, 11);
  scene.sheets[0].level = [](int shot, double x, double y) {
    return noiseLevel(shot, x - 8 * std::floor(x / 8), 0.1 * y);
  };
  return scene;
}

TEST(TrinocularMatchingMasks, RatioFilterRefusesWhatRepeatsItself)
{
  const TrinocularRig pair = syntheticRig(-0.1, 0);
  for (const int shots : {1, 2, 5}) {
    SCOPED_TRACE(std::to_string(shots) + " shots");
    TrinocularMatching matching = matchingOf(pair);
    const auto periodic = shotsOf(periodicScene(pair), shots);
    EXPECT_GT(inner.shareOf(matchSoundly(matching, periodic), Outcome::Matched), 0.5);
    matching.setRatioFilter(15);
    EXPECT_GT(inner.shareOf(matchSoundly(matching, periodic), Outcome::Ambiguous),
              0.95);
    const auto single = shotsOf(flatScene(pair, 11), shots);
    EXPECT_GT(inner.shareOf(matchSoundly(matching, single), Outcome::Matched), 0.95);
  }
}

TEST(TrinocularMatchingMasks, TheOtherPairServesWhereOneRepeatsItself)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  SyntheticScene scene = periodicScene(rig);
  scene.sheets[0].level = [](int shot, double x, double y) {
    return noiseLevel(shot, x - 8 * std::floor(x / 8), y);
  };
  TrinocularMatching matching = matchingOf(rig);
  matching.setRatioFilter(15);
  const MatchErrors errors =
      errorsOf(matchSoundly(matching, shotsOf(scene, 5)), trueDisparities(scene));
  EXPECT_LT(errors.missing, 0.05);
  EXPECT_LT(errors.bad, 0.01);
}

/** A wall whose right part is not lit by the projector: the same grey in all shots,
 * with noise of up to one grey level. */
SyntheticScene
halfLitScene(const TrinocularRig& rig)
{
  SyntheticScene scene = flatScene(rig, 6);
  scene.sheets[0].level = [](int shot, double x, double y) {
    const double noise = noiseLevel(shot + 50, 3 * x, 3 * y) / 128 - 1;
    return x < 70 ? noiseLevel(shot, x, y) : 40 + noise;
  };
  return scene;
}

TEST(TrinocularMatchingMasks, WhatIsNotLitIsUntextured)
{
  // pixels for which all searched disparities are inside the neighbours' images
  constexpr Area dark{76, 88, 10, 58}, lit{15, 65, 10, 75};
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  for (const int shots : {1, 2, 3, 5, 10}) {
    SCOPED_TRACE(std::to_string(shots) + " shots");
    const MatchedDisparity matched =
        matchSoundly(rig, shotsOf(halfLitScene(rig), shots));
    EXPECT_GT(dark.shareOf(matched, Outcome::Untextured), 0.99);
    EXPECT_GT(lit.shareOf(matched, Outcome::Matched), 0.97);
  }
  TrinocularMatching matching = matchingOf(rig);
  matching.setPeakFilter(100); // higher than any pixel can stand out
  const MatchedDisparity none = matchSoundly(matching, shotsOf(halfLitScene(rig), 5));
  EXPECT_EQ(countOutcomes(none)[static_cast<std::size_t>(Outcome::Matched)], 0u);
}

TEST(TrinocularMatchingMasks, PlacesOutsideOfBothNeighboursAreOutOfView)
{
  constexpr int offset = 8;
  for (const double horizontal : {-0.1, 0.1, 0.0})
    for (const double vertical : {-0.1, 0.1, 0.0}) {
      if (horizontal == 0 && vertical == 0)
        continue;
      const TrinocularRig rig = syntheticRig(horizontal, vertical);
      TrinocularMatching matching = matchingOf(rig);
      matching.setXOffset(offset);
      const MatchedDisparity matched =
          matchSoundly(matching, shotsOf(flatScene(rig, 12), 5));
      const auto isOutside = [&](double disparity, int column, int row) {
        const SyntheticScene there = flatScene(rig, disparity);
        return !isSeenBy(RigCamera::Horizontal, there, column, row) &&
               !isSeenBy(RigCamera::Vertical, there, column, row);
      };
      int unknown = 0, wrong = 0;
      for (int row = 0; row < rig.height; ++row)
        for (int column = 0; column < rig.width; ++column) {
          const bool is_out = Area::at(matched, column, row) == Outcome::OutOfView;
          unknown += isOutside(offset, column, row) && !is_out;
          wrong += !isOutside(13, column, row) && is_out;
        }
      EXPECT_EQ(unknown, 0) << horizontal << " m, " << vertical << " m";
      EXPECT_EQ(wrong, 0) << horizontal << " m, " << vertical << " m";
    }
}

/** Frames with a different disparity in the vertical camera than in the horizontal
 * one. */
std::vector<TrinocularFrame::Ptr>
contradictoryShots(double horizontal, double vertical)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  const auto shots = shotsOf(flatScene(rig, horizontal), 5);
  const auto other = shotsOf(flatScene(rig, vertical), 5);
  for (std::size_t i = 0; i < shots.size(); ++i)
    shots[i]->image(RigCamera::Vertical) = other[i]->image(RigCamera::Vertical);
  return shots;
}

/** Fraction of the inner pixels that are matched within 0.2 px of a disparity. */
double
shareAt(const MatchedDisparity& matched, double disparity)
{
  int count = 0;
  for (int row = inner.top; row < inner.bottom; ++row)
    for (int column = inner.left; column < inner.right; ++column)
      count += std::abs(static_cast<double>(matched.disparity.at(column, row)) -
                        disparity) < 0.2;
  return count /
         static_cast<double>((inner.right - inner.left) * (inner.bottom - inner.top));
}

TEST(TrinocularMatchingMasks, PairsThatDisagreeAreToldOrTheBetterOneIsTaken)
{
  TrinocularMatching matching = matchingOf(syntheticRig(-0.1, -0.1));
  const auto shots = contradictoryShots(6, 11);
  const MatchedDisparity either = matchSoundly(matching, shots);
  EXPECT_GT(shareAt(either, 6) + shareAt(either, 11), 0.98);
  EXPECT_LT(matching.getReport().by_both_pairs, either.outcome.size() / 50);
  matching.setRequirePairAgreement(true);
  EXPECT_GT(inner.shareOf(matchSoundly(matching, shots), Outcome::PairsDisagree), 0.98);
  const MatchedDisparity agreed =
      matchSoundly(matching, shotsOf(flatScene(syntheticRig(-0.1, -0.1), 6), 5));
  EXPECT_GT(inner.shareOf(agreed, Outcome::Matched), 0.98);
  EXPECT_GT(matching.getReport().by_both_pairs,
            countOutcomes(agreed)[0] * std::size_t{6} / 10);
}

TEST(TrinocularMatchingMasks, PairsThatAgreeAreJoinedByTheirMean)
{
  TrinocularMatching matching = matchingOf(syntheticRig(-0.1, -0.1));
  const auto shots = contradictoryShots(8, 8.8);
  EXPECT_GT(shareAt(matchSoundly(matching, shots), 8.4), 0.9);
  matching.setPairAgreement(0.4);
  EXPECT_LT(shareAt(matchSoundly(matching, shots), 8.4), 0.1);
  matching.setRequirePairAgreement(true);
  EXPECT_GT(inner.shareOf(matchSoundly(matching, shots), Outcome::PairsDisagree), 0.9);
}

TEST(TrinocularMatchingMasks, LinesAlongTheRowsAreMatchedByTheVerticalPair)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  SyntheticScene scene = flatScene(rig, 9.5);
  scene.sheets[0].level = [](int shot, double x, double y) {
    const double grain = noiseLevel(shot + 50, 3 * x, 3 * y) / 128 - 1;
    return noiseLevel(shot, 0, y) + 2 * grain;
  };
  for (const int shots : {1, 2, 5, 10}) {
    SCOPED_TRACE(std::to_string(shots) + " shots");
    const MatchErrors errors =
        errorsOf(matchSoundly(rig, shotsOf(scene, shots)), trueDisparities(scene));
    EXPECT_LT(errors.missing, 0.1);
    EXPECT_LT(errors.bad, 0.05);
    EXPECT_LT(errors.median, 0.2);
  }
}

} // namespace
} // namespace pcl::acmap::test
