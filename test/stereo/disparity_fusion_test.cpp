#include "tiny_fusion.h"

#include <pcl/core/exceptions.h>

#include <functional>

namespace pcl::acmap::test {
namespace {

using Method = DisparityFusion::Method;

TEST(DisparityFusion, EachMethodFindsAFarWall)
{
  for (const Method method : fusion_methods) {
    DisparityFusion fusion = fusionOf(method, 4);
    EXPECT_EQ(fusion.shots(), 4u);
    const MatchedDisparity result = fused(fusion);
    const DisparityFusionReport report = fusion.getReport();
    EXPECT_EQ(report.shots, 4u);
    EXPECT_EQ(report.off_shots, 0u);
    EXPECT_EQ(report.outcomes, countOutcomes(result));
    EXPECT_GT(report.outcomes[0], 48u * 36 * 8 / 10);
    for (std::size_t i = 0; i < result.outcome.size(); ++i)
      if (result.outcome[i] == DisparityOutcome::Matched) {
        EXPECT_NEAR(result.disparity.values[i], 0, 0.2);
        EXPECT_GE(result.support[i], 3);
        EXPECT_LE(result.support[i], 4);
      }
  }
}

TEST(DisparityFusion, MoreShotsMayFollow)
{
  for (const Method method : fusion_methods) {
    DisparityFusion fusion = fusionOf(method, 3);
    const MatchedDisparity before = fused(fusion);
    expectSame(fused(fusion), before);
    fusion.addShot(noiseShot(3));
    DisparityFusion other = fusionOf(method, 4);
    expectSame(fused(fusion), fused(other));
    EXPECT_EQ(fusion.getReport().shots, 4u);
  }
}

TEST(DisparityFusion, SpaceTimeIsMatchingOfAllShots)
{
  DisparityFusion fusion = fusionOf(Method::SpaceTime, 5);
  fusion.addShot(shotOf(flatImage(90), TrinocularFrame::no_pattern));
  std::vector<TrinocularFrame::ConstPtr> shots;
  for (int i = 0; i < 5; ++i)
    shots.push_back(noiseShot(i));
  TrinocularMatching matching = fusion.getMatching();
  MatchedDisparity wanted;
  matching.match(shots, wanted);
  expectSame(fused(fusion), wanted);
}

TEST(DisparityFusion, WithoutAPatternThereIsNoDisparity)
{
  for (const Method method : fusion_methods) {
    DisparityFusion fusion = fusionBy(method);
    for (int shots = 0; shots < 2; ++shots) {
      const MatchedDisparity result = fused(fusion);
      EXPECT_EQ(result.outcome,
                std::vector<DisparityOutcome>(48 * 36, DisparityOutcome::TooFewShots));
      EXPECT_EQ(result.support, std::vector<std::uint16_t>(48 * 36));
      EXPECT_TRUE(std::isnan(result.disparity.at(47, 35)));
      EXPECT_EQ(fusion.getReport().remarks.size(), 1u);
      fusion.addShot(shotOf(flatImage(90), TrinocularFrame::no_pattern));
    }
  }
}

TEST(DisparityFusion, ColorIsTheMeanOfShotsWithoutPattern)
{
  DisparityFusion fusion = fusionBy(Method::SpaceTime);
  EXPECT_TRUE(fusion.getColor().empty());
  fusion.addShot(shotOf(flatImage(200), 0));
  fusion.addShot(shotOf(flatImage(101, 3), 1));
  EXPECT_EQ(fusion.getColor(), flatImage(151, 3)); // 150.5
  fused(fusion);
  EXPECT_NE(fusion.getReport().remarks.at(0).find("patterns' light"),
            std::string::npos);
  fusion.addShot(shotOf(flatImage(10), TrinocularFrame::no_pattern));
  CameraImage colored = flatImage(20, 3);
  colored.values[4] = 255; // green of the second pixel
  fusion.addShot(shotOf(colored, TrinocularFrame::no_pattern));
  fusion.addShot(shotOf(flatImage(10), TrinocularFrame::no_pattern));
  CameraImage wanted = flatImage(13, 3);
  wanted.values[4] = 92; // of 10, 255, 10
  EXPECT_EQ(fusion.getColor(), wanted);
  EXPECT_EQ(fusion.shots(), 5u);
  fused(fusion);
  EXPECT_EQ(fusion.getReport().off_shots, 3u);
  EXPECT_TRUE(fusion.getReport().remarks.empty());
}

TEST(DisparityFusion, RefusedShotLeavesThoseSoFar)
{
  const auto broken = [](const std::function<void(TrinocularFrame&)>& change) {
    const auto shot = noiseShot(9);
    change(*shot);
    return shot;
  };
  const std::vector<TrinocularFrame::ConstPtr> refused = {
      nullptr,
      broken([](TrinocularFrame& shot) { shot.images[0] = {}; }),
      broken([](TrinocularFrame& shot) { shot.images[2] = {}; }),
      broken([](TrinocularFrame& shot) { shot.images[1].width = 36; }),
      broken([](TrinocularFrame& shot) { shot.images[1].values.pop_back(); }),
      broken([](TrinocularFrame& shot) { shot.images[0].channels = 2; })};
  for (const Method method : fusion_methods) {
    DisparityFusion fusion = fusionOf(method, 3);
    const MatchedDisparity wanted = fused(fusion);
    const CameraImage color = fusion.getColor();
    for (const auto& shot : refused)
      EXPECT_THROW(fusion.addShot(shot), BadArgumentException);
    EXPECT_EQ(fusion.shots(), 3u);
    EXPECT_EQ(fusion.getColor(), color);
    EXPECT_EQ(fusion.getReport().coverage.size(), 3u);
    expectSame(fused(fusion), wanted);
  }
}

TEST(DisparityFusion, CancelledCallsLeaveEverything)
{
  for (const Method method : fusion_methods) {
    DisparityFusion fusion = fusionOf(method, 3);
    MatchedDisparity result = fused(fusion);
    const MatchedDisparity wanted = result;
    fusion.setProgressCallback([](double, const std::string&) { return false; });
    if (method != Method::SpaceTime) {
      EXPECT_THROW(fusion.addShot(noiseShot(3)), CancelledException);
    }
    EXPECT_EQ(fusion.shots(), 3u);
    EXPECT_THROW(fusion.fuse(result), CancelledException);
    expectSame(result, wanted);
    fusion.setProgressCallback({});
    expectSame(fused(fusion), wanted);
  }
}

TEST(DisparityFusion, NewObservationOrRigOrMatchingForgetsTheShots)
{
  const auto shotsAfter = [](const std::function<void(DisparityFusion&)>& change) {
    DisparityFusion fusion = fusionOf(Method::Median, 2);
    change(fusion);
    EXPECT_EQ(fusion.getReport().coverage.size(), fusion.shots());
    EXPECT_EQ(fusion.getColor().empty(), fusion.shots() == 0);
    return fusion.shots();
  };
  EXPECT_EQ(shotsAfter([](auto& fusion) { fusion.clear(); }), 0u);
  EXPECT_EQ(shotsAfter([](auto& fusion) { fusion.setInputRig(tinyRig()); }), 0u);
  EXPECT_EQ(shotsAfter([](auto& fusion) { fusion.setMatching({}); }), 0u);
  EXPECT_EQ(shotsAfter([](auto& fusion) { fusion.setMethod(Method::Statistical); }),
            0u);
  EXPECT_EQ(shotsAfter([](auto& fusion) { fusion.setMethod(Method::Median); }), 2u);
  EXPECT_EQ(shotsAfter([](auto& fusion) { fusion.setMinimumSupport(1); }), 2u);
  EXPECT_EQ(shotsAfter([](auto& fusion) { fusion.setPassive(true); }), 2u);
}

TEST(DisparityFusion, TakesOfMatchingOnlyHowShotsAreMatched)
{
  DisparityFusion fusion = fusionBy(Method::SpaceTime);
  fusion.setNumberOfThreads(2);
  TrinocularMatching matching;
  TrinocularRig other = tinyRig();
  other.width = 96;
  matching.setInputRig(other);
  matching.setNumberOfThreads(1);
  matching.setXOffset(3);
  matching.setProgressCallback([](double, const std::string&) { return false; });
  fusion.setMatching(matching);
  EXPECT_EQ(fusion.getMatching().getXOffset(), 3);
  EXPECT_EQ(fusion.getMatching().getInputRig().width, 48);
  EXPECT_EQ(fusion.getMatching().getNumberOfThreads(), 2u);
  fusion.addShot(noiseShot(0));
  EXPECT_NO_THROW(fused(fusion));
}

TEST(DisparityFusion, HasAtMost256Shots)
{
  DisparityFusion fusion = fusionBy(Method::SpaceTime);
  const auto lit = noiseShot(0);
  for (int i = 0; i < 255; ++i)
    fusion.addShot(lit);
  fusion.addShot(shotOf(flatImage(90), TrinocularFrame::no_pattern));
  EXPECT_FALSE(fusion.wantsAnotherShot());
  EXPECT_THROW(fusion.addShot(lit), BadArgumentException);
  EXPECT_THROW(fusion.addShot(shotOf(flatImage(90), TrinocularFrame::no_pattern)),
               BadArgumentException);
  EXPECT_EQ(fusion.shots(), 256u);
}

TEST(DisparityFusion, NeedsARig)
{
  DisparityFusion fusion;
  MatchedDisparity result;
  EXPECT_TRUE(fusion.wantsAnotherShot());
  EXPECT_THROW(fusion.addShot(noiseShot(0)), InitFailedException);
  EXPECT_THROW(fusion.fuse(result), InitFailedException);
  fusion.clear();
  EXPECT_EQ(fusion.shots(), 0u);
  EXPECT_TRUE(fusion.getColor().empty());
}

TEST(DisparityFusion, MethodsHaveNames)
{
  EXPECT_EQ(disparityFusionMethod("median"), Method::Median);
  EXPECT_EQ(disparityFusionMethod("statistical"), Method::Statistical);
  EXPECT_EQ(disparityFusionMethod("spacetime"), Method::SpaceTime);
  for (const char* name : {"", "Median", "space-time"})
    EXPECT_THROW(disparityFusionMethod(name), BadArgumentException) << name;
}

} // namespace
} // namespace pcl::acmap::test
