#include "matched_checks.h"
#include "synthetic_shots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace pcl::acmap::test {
namespace {

std::string
wordsFor(const TrinocularRig& rig, double disparity, int shots)
{
  std::ostringstream words;
  words << "baselines " << rig.baseline_horizontal << " and " << rig.baseline_vertical
        << " m, " << disparity << " px, " << shots << " shots";
  return words.str();
}

TEST(TrinocularMatching, FindsKnownShiftsForEveryPlaceOfTheNeighbours)
{
  for (const auto& [horizontal, vertical] : {std::pair(-0.1, -0.1),
                                             std::pair(0.1, -0.1),
                                             std::pair(-0.1, 0.1),
                                             std::pair(0.1, 0.1),
                                             std::pair(-0.1, 0.0),
                                             std::pair(0.1, 0.0),
                                             std::pair(0.0, -0.1),
                                             std::pair(0.0, 0.1),
                                             std::pair(-0.1, -0.06),
                                             std::pair(0.08, 0.12)})
    for (const double disparity : {9.0, 12.4}) {
      const TrinocularRig rig = syntheticRig(horizontal, vertical);
      SCOPED_TRACE(wordsFor(rig, disparity, 5));
      const SyntheticScene scene = flatScene(rig, disparity);
      const MatchErrors errors =
          errorsOf(matchSoundly(rig, shotsOf(scene, 5)), trueDisparities(scene));
      EXPECT_GT(errors.pixels, 5000u);
      EXPECT_LT(errors.missing, 0.02);
      EXPECT_LT(errors.bad, 0.002);
      EXPECT_LT(errors.median, 0.04);
    }
}

/** A wall that is not parallel to the image: neighbouring disparities are different. */
SyntheticScene
slantedScene(const TrinocularRig& rig)
{
  SyntheticScene scene = flatScene(rig, 0);
  scene.sheets[0].disparity = [](double x, double y) {
    return 6.3 + 0.06 * x + 0.03 * y;
  };
  return scene;
}

TEST(TrinocularMatching, FindsAWallFromAnyNumberOfShots)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  const SyntheticScene scene = slantedScene(rig);
  for (const int shots : {1, 2, 3, 4, 5, 10}) {
    SCOPED_TRACE(std::to_string(shots) + " shots");
    const MatchErrors errors =
        errorsOf(matchSoundly(rig, shotsOf(scene, shots)), trueDisparities(scene));
    EXPECT_LT(errors.missing, shots == 1 ? 0.05 : 0.02);
    EXPECT_LT(errors.bad, 0.002);
    EXPECT_LT(errors.median, shots == 1 ? 0.15 : 0.05);
  }
}

TEST(TrinocularMatching, SearchesFromTheOffsetOn)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  const SyntheticScene scene = flatScene(rig, 21.3);
  const auto shots = shotsOf(scene, 5);
  TrinocularMatching matching;
  matching.setInputRig(rig);
  matching.setXOffset(16);
  matching.setMaxDisparity(8);
  const MatchErrors errors =
      errorsOf(matchSoundly(matching, shots), trueDisparities(scene));
  EXPECT_LT(errors.missing, 0.02);
  EXPECT_LT(errors.bad, 0.002);
  EXPECT_LT(errors.median, 0.04);
}

TEST(TrinocularMatching, WallsOutOfRangeAreNotFoundUnderManyPatterns)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  TrinocularMatching matching;
  matching.setInputRig(rig);
  matching.setMaxDisparity(32);
  matching.setCorrelationThreshold(0.8);
  const SyntheticScene scene = flatScene(rig, 40);
  EXPECT_GT(errorsOf(matchSoundly(matching, shotsOf(scene, 10)), trueDisparities(scene))
                .missing,
            0.98);
}

/** Applies a function to all values of a camera's images. */
void
changeLevels(const std::vector<TrinocularFrame::Ptr>& shots,
             RigCamera camera,
             const std::function<int(int)>& rule)
{
  for (const TrinocularFrame::Ptr& shot : shots)
    for (std::uint8_t& value : shot->image(camera).values)
      value = static_cast<std::uint8_t>(rule(value));
}

TEST(TrinocularMatching, GainAndOffsetOfACameraDoNotMatter)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  const SyntheticScene scene = slantedScene(rig);
  for (const int shots : {1, 2, 3, 10})
    for (const RigCamera camera :
         {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical}) {
      SCOPED_TRACE(std::to_string(shots) + " shots, " + nameOf(camera));
      auto frames = shotsOf(scene, shots);
      for (const RigCamera all :
           {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical})
        changeLevels(frames, all, [](int value) { return value / 2 * 2; });
      const MatchedDisparity wanted = matchSoundly(rig, frames);
      changeLevels(frames, camera, [](int value) { return value / 2 + 70; });
      const Likeness likeness = likenessOf(matchSoundly(rig, frames), wanted);
      EXPECT_GT(likeness.same_outcome, 0.99);
      EXPECT_GT(likeness.matched, 0.5);
      EXPECT_LT(likeness.farthest, 0.05);
    }
}

/** The frame with rows and columns, and therefore its cameras, exchanged. */
TrinocularFrame::Ptr
transposed(const TrinocularFrame& shot)
{
  const auto turn = [](const CameraImage& image) {
    CameraImage turned{image.height, image.width, 1, {}};
    for (int row = 0; row < turned.height; ++row)
      for (int column = 0; column < turned.width; ++column)
        turned.values.push_back(
            image.values[static_cast<std::size_t>(column * image.width + row)]);
    return turned;
  };
  auto result = std::make_shared<TrinocularFrame>(shot);
  result->image(RigCamera::Reference) = turn(shot.image(RigCamera::Reference));
  result->image(RigCamera::Horizontal) = turn(shot.image(RigCamera::Vertical));
  result->image(RigCamera::Vertical) = turn(shot.image(RigCamera::Horizontal));
  return result;
}

MatchedDisparity
transposed(const MatchedDisparity& matched)
{
  MatchedDisparity result = matched;
  DisparityImage& image = result.disparity;
  std::swap(image.width, image.height);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const auto to = static_cast<std::size_t>(row * image.width + column);
      const auto from = static_cast<std::size_t>(column * image.height + row);
      image.values[to] = matched.disparity.values[from];
      result.outcome[to] = matched.outcome[from];
    }
  return result;
}

TEST(TrinocularMatching, RowsAndColumnsAreAlike)
{
  const TrinocularRig rig = syntheticRig(-0.1, 0.1);
  TrinocularRig turned_rig = syntheticRig(0.1, -0.1);
  std::swap(turned_rig.width, turned_rig.height);
  std::swap(turned_rig.center_x, turned_rig.center_y);
  for (const int shots : {1, 2, 5}) {
    const auto frames = shotsOf(slantedScene(rig), shots);
    std::vector<TrinocularFrame::Ptr> turned;
    for (const TrinocularFrame::Ptr& frame : frames)
      turned.push_back(transposed(*frame));
    const Likeness likeness = likenessOf(matchSoundly(turned_rig, turned),
                                         transposed(matchSoundly(rig, frames)));
    EXPECT_GT(likeness.same_outcome, 0.98) << shots;
    EXPECT_GT(likeness.matched, 0.5) << shots;
    EXPECT_LT(likeness.farthest, 0.1) << shots;
  }
}

TEST(TrinocularMatching, ColourIsAsGoodAsGrey)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  const auto grey = shotsOf(slantedScene(rig), 3);
  auto mixed = shotsOf(slantedScene(rig), 3);
  for (const std::size_t shot : {0u, 2u})
    for (CameraImage& image : mixed[shot]->images) {
      std::vector<std::uint8_t> colour;
      for (const std::uint8_t value : image.values)
        colour.insert(colour.end(), 3, value);
      image.values = colour;
      image.channels = 3;
    }
  const MatchedDisparity wanted = matchSoundly(rig, grey);
  EXPECT_GT(shareMatched(wanted), 0.5);
  EXPECT_TRUE(isSame(matchSoundly(rig, mixed), wanted));
}

TEST(TrinocularMatching, ShotsWithoutAPatternAreLeftOutAmongOthers)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  const auto lit = shotsOf(slantedScene(rig), 4);
  auto all = lit;
  for (TrinocularFrame::Ptr& shot : shotsOf(flatScene(rig, 3), 2)) {
    shot->pattern = TrinocularFrame::no_pattern;
    all.insert(all.begin() + 1, shot);
  }
  TrinocularMatching matching;
  matching.setInputRig(rig);
  matching.setMaxDisparity(32);
  MatchedDisparity matched;
  matching.match({all.begin(), all.end()}, matched);
  const MatchedDisparity wanted = matchSoundly(rig, lit);
  EXPECT_GT(shareMatched(wanted), 0.5);
  EXPECT_TRUE(isSame(matched, wanted));
  EXPECT_EQ(matching.getReport().shots, 4u);
  EXPECT_EQ(matching.getReport().remarks.size(), 1u);
}

} // namespace
} // namespace pcl::acmap::test
