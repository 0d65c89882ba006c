#include "matched_checks.h"
#include "synthetic_shots.h"

#include <pcl/core/exceptions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

using Shots = std::vector<TrinocularFrame::Ptr>;

/** A rig with a different size than the synthetic one. */
TrinocularRig
tinyRig(int width, int height, double horizontal = -0.1, double vertical = -0.1)
{
  TrinocularRig rig = syntheticRig(horizontal, vertical);
  rig.width = width;
  rig.height = height;
  return rig;
}

Shots
shotsOfLevel(const TrinocularRig& rig, int shots, double level)
{
  SyntheticScene scene = flatScene(rig, 3);
  scene.sheets[0].level = [level](int, double, double) { return level; };
  return shotsOf(scene, shots);
}

std::size_t
count(const MatchedDisparity& matched, DisparityOutcome outcome)
{
  return countOutcomes(matched)[static_cast<std::size_t>(outcome)];
}

TEST(TrinocularMatchingInput, ImagesOfAnySizeAreTaken)
{
  for (const auto& [width, height] : {std::pair(1, 1),
                                      std::pair(2, 1),
                                      std::pair(1, 9),
                                      std::pair(8, 8),
                                      std::pair(3, 40),
                                      std::pair(33, 2)})
    for (const double horizontal : {-0.1, 0.1, 0.0})
      for (const double vertical : {-0.1, 0.1, 0.0})
        for (const int shots : {1, 2, 3, 5}) {
          if (horizontal == 0 && vertical == 0)
            continue;
          const TrinocularRig rig = tinyRig(width, height, horizontal, vertical);
          matchSoundly(rig, shotsOf(flatScene(rig, 1), shots));
        }
}

TEST(TrinocularMatchingInput, ImagesWithoutContrastHaveNoDisparities)
{
  const TrinocularRig rig = tinyRig(40, 30);
  for (const double level : {0.0, 128.0, 255.0})
    for (const int shots : {1, 2, 3, 5, 10}) {
      TrinocularMatching matching;
      matching.setInputRig(rig);
      matching.setMaxDisparity(16);
      const MatchedDisparity matched =
          matchSoundly(matching, shotsOfLevel(rig, shots, level));
      EXPECT_EQ(count(matched, DisparityOutcome::Matched), 0u) << level;
      EXPECT_GT(count(matched, DisparityOutcome::Untextured), 40u * 30u / 2) << level;
      EXPECT_FALSE(matching.getReport().remarks.empty());
    }
}

TEST(TrinocularMatchingInput, OneCameraMayBeBlind)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  const SyntheticScene scene = flatScene(rig, 9);
  for (const RigCamera blind : {RigCamera::Horizontal, RigCamera::Vertical}) {
    const Shots shots = shotsOf(scene, 5);
    for (const TrinocularFrame::Ptr& shot : shots)
      std::fill(shot->image(blind).values.begin(), shot->image(blind).values.end(), 0);
    const MatchErrors errors =
        errorsOf(matchSoundly(rig, shots), trueDisparities(scene));
    EXPECT_LT(errors.missing, 0.05) << nameOf(blind);
    EXPECT_LT(errors.bad, 0.01) << nameOf(blind);
  }
}

TEST(TrinocularMatchingInput, RangesWiderThanTheImageAreSearched)
{
  const TrinocularRig rig = tinyRig(40, 30);
  const SyntheticScene scene = flatScene(rig, 4);
  TrinocularMatching matching;
  matching.setInputRig(rig);
  matching.setMaxDisparity(1024);
  const MatchErrors errors =
      errorsOf(matchSoundly(matching, shotsOf(scene, 5)), trueDisparities(scene));
  EXPECT_LT(errors.missing, 0.1);
  EXPECT_LT(errors.bad, 0.02);
  matching.setXOffset(4095);
  const MatchedDisparity beyond = matchSoundly(matching, shotsOf(scene, 5));
  EXPECT_EQ(count(beyond, DisparityOutcome::OutOfView), 40u * 30u);
}

TEST(TrinocularMatchingInput, BaselinesMayDifferManyTimes)
{
  for (const auto& [horizontal, vertical] :
       {std::pair(-0.01, -0.16), std::pair(16.0, 1.0), std::pair(-0.1, 0.008)}) {
    const TrinocularRig rig = tinyRig(40, 30, horizontal, vertical);
    const Shots shots = shotsOf(flatScene(tinyRig(40, 30), 4), 3);
    const MatchedDisparity matched = matchSoundly(rig, shots);
    EXPECT_EQ(matched.outcome.size(), 40u * 30u);
  }
  TrinocularMatching matching;
  for (const auto& [horizontal, vertical] :
       {std::pair(-0.001, -100.0), std::pair(100.0, 1e-50), std::pair(1e-45, -0.1)})
    EXPECT_THROW(matching.setInputRig(tinyRig(40, 30, horizontal, vertical)),
                 BadArgumentException);
}

TEST(TrinocularMatchingInput, OfSeveralShotsWithoutAPatternTheFirstIsMatched)
{
  const TrinocularRig rig = tinyRig(60, 40);
  const SyntheticScene scene = flatScene(rig, 5);
  Shots shots = shotsOf(scene, 1);
  shots.front()->pattern = TrinocularFrame::no_pattern;
  const MatchedDisparity first = matchSoundly(rig, shots);
  shots.resize(4, shots.front());
  TrinocularMatching matching;
  matching.setInputRig(rig);
  MatchedDisparity matched;
  matching.match({shots.begin(), shots.end()}, matched);
  EXPECT_EQ(matched.disparity.values.size(), first.disparity.values.size());
  EXPECT_EQ(matched.outcome, first.outcome);
  EXPECT_EQ(matching.getReport().shots, 1u);
  EXPECT_FALSE(matching.getReport().remarks.empty());
  EXPECT_LT(errorsOf(matched, trueDisparities(scene)).bad, 0.1);
}

TEST(TrinocularMatchingInput, AConstantImageWithoutAPatternHasNoDisparities)
{
  const TrinocularRig rig = tinyRig(60, 40);
  for (const std::uint8_t level : {0, 77, 255}) {
    Shots shots = shotsOf(flatScene(rig, 5), 1);
    shots.front()->pattern = TrinocularFrame::no_pattern;
    for (CameraImage& image : shots.front()->images)
      std::fill(image.values.begin(), image.values.end(), level);
    TrinocularMatching matching;
    matching.setInputRig(rig);
    matching.setXOffset(10);
    MatchedDisparity matched;
    matching.match(*shots.front(), matched);
    EXPECT_EQ(countOutcomes(matched)[0], 0u) << int{level};
    EXPECT_FALSE(matching.getReport().remarks.empty());
  }
}

TEST(TrinocularMatchingInput, UpTo256ShotsAreMatched)
{
  const TrinocularRig rig = tinyRig(24, 16);
  const SyntheticScene scene = flatScene(rig, 3);
  Shots shots = shotsOf(scene, 256);
  const MatchedDisparity matched = matchSoundly(rig, shots);
  EXPECT_LT(errorsOf(matched, trueDisparities(scene)).bad, 0.02);
  EXPECT_EQ(*std::max_element(matched.support.begin(), matched.support.end()), 256);
  shots.push_back(shots.front());
  TrinocularMatching matching;
  matching.setInputRig(rig);
  MatchedDisparity untouched;
  EXPECT_THROW(matching.match({shots.begin(), shots.end()}, untouched),
               BadArgumentException);
}

/** A result that no run can produce. */
MatchedDisparity
sentinel()
{
  MatchedDisparity matched;
  matched.disparity.width = 7;
  matched.disparity.values.push_back(42);
  matched.support.push_back(3);
  return matched;
}

/** Modified shots must be rejected with a certain word in the message, without changing
 * the output. */
void
expectRefused(const TrinocularRig& rig,
              const std::string& word,
              const std::function<void(Shots&)>& change)
{
  SCOPED_TRACE(word);
  Shots shots = shotsOf(flatScene(rig, 3), 2);
  change(shots);
  TrinocularMatching matching;
  matching.setInputRig(rig);
  MatchedDisparity matched = sentinel();
  EXPECT_THAT(
      [&] {
        matching.match({shots.begin(), shots.end()}, matched);
      },
      testing::ThrowsMessage<BadArgumentException>(HasSubstr(word)))
      << "was matched";
  EXPECT_TRUE(isSame(matched, sentinel()));
}

TEST(TrinocularMatchingInput, FramesThatDoNotFitAreRefused)
{
  const TrinocularRig rig = tinyRig(20, 16);
  const auto change = [&](const std::string& word,
                          RigCamera camera,
                          const std::function<void(CameraImage&)>& rule) {
    expectRefused(rig, word, [&](Shots& shots) { rule(shots[1]->image(camera)); });
  };
  const auto all = {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  for (const RigCamera camera : all) {
    change(nameOf(camera), camera, [](CameraImage& image) { image = {}; });
    change(nameOf(camera), camera, [](CameraImage& image) { image.values.pop_back(); });
    change(nameOf(camera), camera, [](CameraImage& image) {
      image.width = 16; // the same values with a different shape
      image.height = 20;
    });
    change("20 x 16", camera, [](CameraImage& image) {
      image.height = 15;
      image.values.resize(20 * 15);
    });
    change("channels", camera, [](CameraImage& image) {
      image.channels = 2;
      image.values.resize(2 * 20 * 16);
    });
  }
  expectRefused(rig, "null", [](Shots& shots) { shots[1].reset(); });
  expectRefused(rig, "[1, 256]", [](Shots& shots) { shots.clear(); });
}

TEST(TrinocularMatchingInput, RigsThatCannotMatchAreRefused)
{
  TrinocularMatching matching;
  MatchedDisparity matched;
  EXPECT_THROW(matching.getInputRig(), InitFailedException);
  EXPECT_THROW(matching.match(TrinocularFrame(), matched), InitFailedException);
  EXPECT_THROW(matching.setInputRig(syntheticRig(0, 0)), BadArgumentException);
  EXPECT_THROW(matching.setInputRig(tinyRig(0, 5)), BadArgumentException);
  EXPECT_THROW(matching.getInputRig(), InitFailedException) << "nothing was taken";
}

TEST(TrinocularMatchingInput, CancellingLeavesTheOutputUntouched)
{
  const TrinocularRig rig = tinyRig(40, 30);
  const Shots shots = shotsOf(flatScene(rig, 4), 3);
  TrinocularMatching matching;
  matching.setInputRig(rig);
  matching.setMaxDisparity(32);
  int cancelled = 0;
  for (int allowed = 0; allowed < 20; ++allowed) {
    int calls = 0;
    double last = 0;
    matching.setProgressCallback([&](double fraction, const std::string& step) {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1);
      EXPECT_FALSE(step.empty());
      last = fraction;
      return calls++ < allowed;
    });
    MatchedDisparity matched = sentinel();
    try {
      matching.match({shots.begin(), shots.end()}, matched);
      EXPECT_LE(calls, allowed);
      EXPECT_EQ(last, 1);
    }
    catch (const CancelledException&) {
      ++cancelled;
      EXPECT_TRUE(isSame(matched, sentinel()));
    }
  }
  EXPECT_GE(cancelled, 2) << "there is no way to stop";
  matching.setProgressCallback({});
  EXPECT_TRUE(isSame(matchSoundly(matching, shots), matchSoundly(rig, shots)));
}

} // namespace
} // namespace pcl::acmap::test
