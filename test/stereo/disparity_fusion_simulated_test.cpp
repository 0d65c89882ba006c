#include "small_scenes.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/simulated_truth.h>
#include <pcl/stereo/disparity_fusion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace pcl::acmap::test {
namespace {

using Method = DisparityFusion::Method;

constexpr std::size_t view = 3; // in the corridor, along a wall

/** Lines with the standard width for a rig with a quarter of the pixels. */
std::vector<RgbImage>
drawPatterns(std::uint32_t count, int lines = 50)
{
  RandomLinePattern pattern;
  pattern.setLineWidths(8, 24);
  pattern.setNumberOfLines(lines);
  std::vector<RgbImage> patterns;
  for (std::uint32_t i = 0; i < count; ++i)
    patterns.push_back(pattern.generate(i));
  return patterns;
}

struct Session {
  TrinocularRig rig;
  std::vector<TrinocularFrame::Ptr> shots; // the first one without a pattern
  SimulatedTruth truth;
};

Session
simulate(const std::vector<RgbImage>& patterns, double power = 1.0)
{
  const SimulatedScene scene = smallScene("corridor", 160);
  SimulatedLight light;
  light.projector.power = power;
  const SimulatedRigGrabber grabber(scene, patterns, light);
  return {scene.rig, grabber.observe(view), truthOf(scene, view, light.projector)};
}

const Session&
corridor()
{
  static const Session session = simulate(drawPatterns(10));
  return session;
}

DisparityFusion
fusionFor(const Session& session, Method method)
{
  DisparityFusion fusion;
  TrinocularMatching matching;
  matching.setMaxDisparity(24);
  fusion.setMatching(matching);
  fusion.setMethod(method);
  fusion.setInputRig(session.rig);
  return fusion;
}

/** Errors at pixels that are lit and seen by a neighbour. */
struct FusionErrors {
  double kept = 0;         // fraction with a disparity
  double bad = 0;          // fraction of these with an error of more than 1 px
  double rms = 0;          // px, of the other ones
  double rms_in_sigma = 0; // of the other ones, in units of sigma
};

FusionErrors
errorsOf(const MatchedDisparity& found, const SimulatedTruth& truth)
{
  double pixels = 0, kept = 0, bad = 0, squares = 0, in_sigma = 0;
  constexpr int neighbours =
      SimulatedTruth::in_horizontal | SimulatedTruth::in_vertical;
  for (std::size_t i = 0; i < truth.visible.size(); ++i) {
    if (!(truth.visible[i] & SimulatedTruth::in_light) ||
        !(truth.visible[i] & neighbours))
      continue;
    ++pixels;
    if (found.outcome[i] != DisparityOutcome::Matched)
      continue;
    ++kept;
    const double error = found.disparity.values[i] - truth.horizontal.values[i];
    if (std::abs(error) > 1) {
      ++bad;
      continue;
    }
    squares += error * error;
    in_sigma += error * error / (found.sigma[i] * found.sigma[i]);
  }
  const double good = kept - bad;
  return {
      kept / pixels, bad / kept, std::sqrt(squares / good), std::sqrt(in_sigma / good)};
}

FusionErrors
errorsBy(Method method, std::size_t patterns)
{
  DisparityFusion fusion = fusionFor(corridor(), method);
  for (std::size_t i = 0; i <= patterns; ++i)
    fusion.addShot(corridor().shots[i]);
  MatchedDisparity fused;
  fusion.fuse(fused);
  return errorsOf(fused, corridor().truth);
}

TEST(DisparityFusionSimulated, FindsLitWallsAndKnowsHowWell)
{
  for (const Method method : {Method::Median, Method::Statistical})
    for (const std::size_t patterns : {5, 10}) {
      SCOPED_TRACE(std::to_string(patterns) + " patterns, method " +
                   std::to_string(static_cast<int>(method)));
      const FusionErrors errors = errorsBy(method, patterns);
      EXPECT_GT(errors.kept, 0.95);
      EXPECT_LT(errors.bad, 0.003);
      EXPECT_LT(errors.rms, 0.08);
      EXPECT_GT(errors.rms_in_sigma, 0.7);
      EXPECT_LT(errors.rms_in_sigma, 1.3);
    }
}

TEST(DisparityFusionSimulated, MoreShotsAreBetterThanOne)
{
  const FusionErrors one = errorsBy(Method::Median, 1);
  for (const Method method : {Method::Median, Method::Statistical, Method::SpaceTime})
    EXPECT_LT(errorsBy(method, 10).rms, 0.5 * one.rms);
}

TEST(DisparityFusionSimulated, ConsistentShotsAreHardlyFewerThanTheMedians)
{
  const FusionErrors median = errorsBy(Method::Median, 10);
  const FusionErrors statistical = errorsBy(Method::Statistical, 10);
  EXPECT_GT(statistical.kept, median.kept - 0.005);
  EXPECT_LT(statistical.rms, median.rms);
}

/** Number of patterns after which no further shot is requested; all if that never
 * happens. */
std::size_t
patternsWanted(const Session& session)
{
  DisparityFusion fusion = fusionFor(session, Method::SpaceTime);
  std::size_t patterns = 0;
  for (const auto& shot : session.shots) {
    if (!fusion.wantsAnotherShot())
      break;
    fusion.addShot(shot);
    patterns += shot->pattern == TrinocularFrame::no_pattern ? 0 : 1;
  }
  return patterns;
}

TEST(DisparityFusionSimulated, PatternsAreThrownWhileTheyHelp)
{
  const std::size_t dense = patternsWanted(corridor());
  EXPECT_GE(dense, 4u);
  EXPECT_LE(dense, 7u);
  EXPECT_EQ(patternsWanted(simulate(drawPatterns(10, 5))), 10u);  // few lines each
  EXPECT_EQ(patternsWanted(simulate(drawPatterns(10), 0.0)), 3u); // the lamp is off
}

TEST(DisparityFusionSimulated, CoverageIsTheLitShare)
{
  DisparityFusion fusion = fusionFor(corridor(), Method::SpaceTime);
  for (const auto& shot : corridor().shots)
    fusion.addShot(shot);
  const std::vector<double> coverage = fusion.getReport().coverage;
  ASSERT_EQ(coverage.size(), 10u);
  EXPECT_GT(coverage.front(), 0.3); // lines cover about half of the lit area
  EXPECT_LT(coverage.front(), coverage.back() - 0.1);
  double lit = 0;
  for (const std::uint8_t flags : corridor().truth.visible)
    lit += flags & SimulatedTruth::in_light ? 1 : 0;
  EXPECT_NEAR(coverage.back(),
              lit / static_cast<double>(corridor().truth.visible.size()),
              0.04);
}

} // namespace
} // namespace pcl::acmap::test
