#include "matched_checks.h"
#include "small_scenes.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/random.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/simulated_truth.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

/** A projector with the standard ratio between its resolution and that of the small
 * rig. */
SimulatedLight
smallLight()
{
  SimulatedLight light;
  SimulatedProjector& projector = light.projector;
  projector.width = 320;
  projector.height = 240;
  projector.focal_length = 291;
  projector.center_x = 159.5;
  projector.center_y = 119.5;
  projector.aperture_radius = 200;
  return light;
}

std::vector<RgbImage>
patternsFor(const SimulatedProjector& projector, int count)
{
  RandomLinePattern pattern;
  pattern.setSize(projector.width, projector.height);
  pattern.setNumberOfLines(65);
  pattern.setDisparityRange(32);
  std::vector<RgbImage> patterns;
  for (int i = 0; i < count; ++i)
    patterns.push_back(pattern.generate(static_cast<std::uint32_t>(i)));
  return patterns;
}

/** An oblique blank wall at 1.8 m with a blank box in front of it; 200 x 150 pixels. */
SimulatedScene
wallWithBox()
{
  SimulatedScene scene = wallAt(2.2);
  scene.geometry = {};
  scene.geometry.addRectangle(
      "wall", "wall", {{-3, 3, 2.6}, {6, 0, -1.2}, {0, -6, 0}}, {{170, 170, 165}, 0});
  scene.geometry.addBox(
      "box", {-0.25, -0.15, 1.35}, {0.2, 0.35, 1.6}, {{180, 150, 120}, 0});
  scene.rig = smallRig(200);
  return scene;
}

/** Shots of the scene under patterns, without the dark shot. */
std::vector<TrinocularFrame::Ptr>
litShots(const SimulatedScene& scene, const std::vector<RgbImage>& patterns)
{
  const SimulatedRigGrabber grabber(scene, patterns, smallLight());
  auto frames = grabber.observe(0);
  frames.erase(frames.begin());
  return frames;
}

/** Is a pixel of the reference lit and seen by a neighbour of the rig? */
bool
canBeMatched(const TrinocularRig& rig, std::uint8_t flags)
{
  return (flags & SimulatedTruth::in_light) &&
         ((rig.baseline_horizontal != 0 && (flags & SimulatedTruth::in_horizontal)) ||
          (rig.baseline_vertical != 0 && (flags & SimulatedTruth::in_vertical)));
}

/** True disparities of the pixels that can be matched, or of the other ones. */
DisparityImage
truthWhere(const SimulatedScene& scene, bool matchable)
{
  const SimulatedTruth truth = truthOf(scene, 0, smallLight().projector);
  DisparityImage image =
      scene.rig.baseline_horizontal != 0 ? truth.horizontal : truth.vertical;
  for (std::size_t i = 0; i < image.values.size(); ++i)
    if (canBeMatched(scene.rig, truth.visible[i]) != matchable)
      image.values[i] = std::numeric_limits<float>::quiet_NaN();
  return image;
}

MatchErrors
errorsUnder(const SimulatedScene& scene, const std::vector<RgbImage>& patterns)
{
  return errorsOf(matchSoundly(scene.rig, litShots(scene, patterns)),
                  truthWhere(scene, true));
}

/** The scene with only one of the neighbours. */
SimulatedScene
withPair(SimulatedScene scene, RigCamera neighbour)
{
  (neighbour == RigCamera::Horizontal ? scene.rig.baseline_vertical
                                      : scene.rig.baseline_horizontal) = 0;
  return scene;
}

struct Wanted {
  int shots;
  double missing_or_bad; // fraction
  double median;         // px
};

TEST(TrinocularMatchingSimulated, FindsBlankWallsUnderPatterns)
{
  const SimulatedScene scene = wallWithBox();
  for (const Wanted& wanted : {Wanted{1, 0.06, 0.04},
                               Wanted{2, 0.025, 0.03},
                               Wanted{3, 0.012, 0.02},
                               Wanted{5, 0.005, 0.015},
                               Wanted{10, 0.002, 0.01}}) {
    const MatchErrors errors =
        errorsUnder(scene, patternsFor(smallLight().projector, wanted.shots));
    SCOPED_TRACE(std::to_string(wanted.shots) + " shots");
    EXPECT_GT(errors.pixels, 200u * 150u * 3 / 4);
    EXPECT_LT(errors.missing + errors.bad, wanted.missing_or_bad);
    EXPECT_LT(errors.median, wanted.median);
  }
}

TEST(TrinocularMatchingSimulated, StandardDeviationsAreThoseOfTheErrors)
{
  const SimulatedScene scene = wallWithBox();
  for (const auto& rig_of : {scene,
                             withPair(scene, RigCamera::Horizontal),
                             withPair(scene, RigCamera::Vertical)})
    for (const int shots : {1, 2, 3, 5, 10}) {
      const MatchErrors errors =
          errorsUnder(rig_of, patternsFor(smallLight().projector, shots));
      EXPECT_GT(errors.rms_in_sigma, 0.7) << shots;
      EXPECT_LT(errors.rms_in_sigma, 1.3) << shots;
      EXPECT_LT(errors.beyond, 0.05) << shots;
    }
}

TEST(TrinocularMatchingSimulated, WhatIsHiddenOrUnlitIsRarelyMatchedWrongly)
{
  const SimulatedScene scene = wallWithBox();
  const MatchedDisparity matched =
      matchSoundly(scene.rig, litShots(scene, patternsFor(smallLight().projector, 10)));
  EXPECT_GT(shareMatched(matched), 0.5);
  const MatchErrors errors = errorsOf(matched, truthWhere(scene, false));
  EXPECT_GT(errors.pixels, 1000u);
  EXPECT_LT(errors.bad, 0.05);
}

/** Patterns of lines that are within two degrees of the rows. */
std::vector<RgbImage>
rowPatternsFor(const SimulatedProjector& projector, int count)
{
  std::vector<RgbImage> patterns;
  for (int k = 0; k < count; ++k) {
    Random random(static_cast<std::uint64_t>(k));
    RgbImage pattern{projector.width, projector.height, {}};
    pattern.values.assign(
        static_cast<std::size_t>(3 * projector.width * projector.height), 0);
    for (int line = 0; line < 40; ++line) {
      const double begin = random.uniform(-10, projector.height + 10);
      const double slope = random.uniform(-0.035, 0.035);
      const double width = random.uniform(2, 6);
      const auto level = static_cast<std::uint8_t>(random.uniform(64, 256));
      for (int row = 0; row < projector.height; ++row)
        for (int column = 0; column < projector.width; ++column)
          if (std::abs(row - begin - slope * column) < width / 2)
            std::fill_n(pattern.at(column, row), 3, level);
    }
    patterns.push_back(pattern);
  }
  return patterns;
}

TEST(TrinocularMatchingSimulated, LinesAlongTheRowsAreMatchedByTheVerticalPair)
{
  const SimulatedScene scene = wallWithBox();
  for (const int shots : {2, 5, 10}) {
    SCOPED_TRACE(std::to_string(shots) + " shots");
    const auto patterns = rowPatternsFor(smallLight().projector, shots);
    const MatchErrors both = errorsUnder(scene, patterns);
    const MatchErrors pair =
        errorsUnder(withPair(scene, RigCamera::Horizontal), patterns);
    EXPECT_LT(both.missing + both.bad, shots == 2 ? 0.05 : 0.02);
    EXPECT_LT(both.median, 0.025);
    EXPECT_GT(pair.median, 2 * both.median) << "the horizontal pair needs no other";
  }
}

} // namespace
} // namespace pcl::acmap::test
