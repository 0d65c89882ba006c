#include "tiny_fusion.h"

#include <pcl/core/exceptions.h>

namespace pcl::acmap::test {
namespace {

using Method = DisparityFusion::Method;

TEST(PassiveFusion, MatchesTheFirstShotWithoutAPattern)
{
  const auto dark = noiseWithoutPattern();
  for (const Method method : fusion_methods) {
    DisparityFusion fusion = fusionBy(method);
    EXPECT_FALSE(fusion.getPassive());
    fusion.setPassive(true);
    EXPECT_TRUE(fusion.getPassive());
    EXPECT_EQ(fused(fusion).outcome[0], DisparityOutcome::TooFewShots);
    fusion.addShot(dark);
    TrinocularMatching matching = fusion.getMatching();
    MatchedDisparity wanted;
    matching.match(*dark, wanted);
    expectSame(fused(fusion), wanted);
    const DisparityFusionReport report = fusion.getReport();
    EXPECT_TRUE(report.is_passive);
    EXPECT_EQ(report.shots, 0u);
    EXPECT_EQ(report.off_shots, 1u);
    EXPECT_EQ(report.outcomes, countOutcomes(wanted));
    EXPECT_GT(report.outcomes[0], 48u * 36 * 8 / 10);
    EXPECT_TRUE(report.remarks.empty());
    EXPECT_EQ(fusion.getColor().values[0], dark->images[0].values[0]);

    fusion.addShot(shotOf(flatImage(90), TrinocularFrame::no_pattern));
    expectSame(fused(fusion), wanted);
    ASSERT_EQ(fusion.getReport().remarks.size(), 1u);
    EXPECT_NE(fusion.getReport().remarks[0].find("of 2 shots"), std::string::npos);

    fusion.setPassive(false);
    EXPECT_EQ(fused(fusion).outcome[0], DisparityOutcome::TooFewShots);
    fusion.setPassive(true);
    fusion.clear();
    EXPECT_EQ(fused(fusion).outcome[0], DisparityOutcome::TooFewShots);
  }
}

TEST(PassiveFusion, ChangesNothingUnderPatterns)
{
  for (const Method method : fusion_methods) {
    DisparityFusion fusion = fusionOf(method, 3);
    fusion.addShot(shotOf(flatImage(90), TrinocularFrame::no_pattern));
    const MatchedDisparity wanted = fused(fusion);
    fusion.setPassive(true);
    expectSame(fused(fusion), wanted);
    EXPECT_FALSE(fusion.getReport().is_passive);
  }
}

TEST(PassiveFusion, TakesTheThresholdsOfTheMatching)
{
  const auto countOf = [](DisparityOutcome outcome,
                          const TrinocularMatching& matching) {
    DisparityFusion fusion;
    fusion.setMatching(matching);
    fusion.setPassive(true);
    fusion.setInputRig(tinyRig());
    fusion.addShot(noiseWithoutPattern());
    fused(fusion);
    return fusion.getReport().outcomes[static_cast<std::size_t>(outcome)];
  };
  TrinocularMatching plain;
  plain.setMaxDisparity(8);
  TrinocularMatching textured = plain, correlated = plain;
  textured.setPeakFilter(128);
  correlated.setCorrelationThreshold(1);
  for (const auto& [outcome, strict] :
       {std::pair(DisparityOutcome::Untextured, textured),
        {DisparityOutcome::Uncorrelated, correlated}})
    EXPECT_GT(countOf(outcome, strict), countOf(outcome, plain));
}

TEST(PassiveFusion, CancelledMatchingLeavesEverything)
{
  DisparityFusion fusion = fusionOf(Method::SpaceTime, 3);
  MatchedDisparity result = fused(fusion);
  const MatchedDisparity wanted = result;
  fusion.clear();
  fusion.setPassive(true);
  fusion.addShot(noiseWithoutPattern());
  fusion.setProgressCallback([](double, const std::string&) { return false; });
  EXPECT_THROW(fusion.fuse(result), CancelledException);
  expectSame(result, wanted);
  EXPECT_FALSE(fusion.getReport().is_passive);
}

} // namespace
} // namespace pcl::acmap::test
