#include "matched_checks.h"
#include "run_tool.h"
#include "synthetic_shots.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

namespace pcl::acmap::test {
namespace {

using Shots = std::vector<TrinocularFrame::Ptr>;

/** A wall, a rectangle in front of it and a dark strip, to reach all branches of the
 * matcher. */
Shots
mixedShots(const TrinocularRig& rig, int shots)
{
  SyntheticScene scene = flatScene(rig, 0);
  scene.sheets[0].disparity = [](double x, double y) {
    return 4.1 + 0.05 * x + 0.02 * y;
  };
  scene.sheets[0].level = [](int shot, double x, double y) {
    return x > 30 && x < 45 ? 20 : noiseLevel(shot, x, y);
  };
  scene.sheets.insert(
      scene.sheets.begin(),
      {[](double, double) { return 18.3; },
       [](int shot, double x, double y) { return noiseLevel(shot + 100, x, y); },
       [](double x, double y) { return x > 50 && x < 75 && y > 20 && y < 50; }});
  return shotsOf(scene, shots);
}

TEST(TrinocularMatchingBytes, ThreadsDoNotMatter)
{
  const TrinocularRig rig = syntheticRig(-0.1, 0.07);
  for (const int shots : {1, 2, 3, 6}) {
    const Shots frames = mixedShots(rig, shots);
    TrinocularMatching matching;
    matching.setInputRig(rig);
    matching.setRatioFilter(5);
    matching.setNumberOfThreads(1);
    const MatchedDisparity wanted = matchSoundly(matching, frames);
    EXPECT_GT(countOutcomes(wanted)[0], wanted.outcome.size() / 2);
    for (const unsigned threads : {2u, 8u, 0u}) {
      matching.setNumberOfThreads(threads);
      EXPECT_TRUE(isSame(matchSoundly(matching, frames), wanted)) << threads;
    }
  }
}

TEST(TrinocularMatchingBytes, EarlierRunsDoNotMatter)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  TrinocularRig small = syntheticRig(0, 0.08);
  small.width = 50;
  small.height = 70;
  TrinocularMatching matching;
  const auto match = [&](const TrinocularRig& with, int shots, int disparities) {
    matching.setInputRig(with);
    matching.setMaxDisparity(disparities);
    TrinocularMatching other(matching);
    const Shots frames = mixedShots(with, shots);
    const MatchedDisparity matched = matchSoundly(matching, frames);
    EXPECT_TRUE(isSame(matched, matchSoundly(other, frames)));
    return matched;
  };
  const MatchedDisparity first = match(rig, 3, 40);
  match(small, 6, 20);
  match(rig, 1, 70);
  match(small, 2, 33);
  EXPECT_TRUE(isSame(match(rig, 3, 40), first));
}

TEST(TrinocularMatchingBytes, CopiesHaveTheSettingsOfTheOriginal)
{
  const TrinocularRig rig = syntheticRig(-0.1, -0.1);
  const Shots frames = mixedShots(rig, 3);
  TrinocularMatching matching;
  matching.setInputRig(rig);
  matching.setXOffset(2);
  matching.setMaxDisparity(24);
  matching.setRatioFilter(5);
  matching.setPeakFilter(10);
  matching.setCorrelationThreshold(0.9);
  matching.setLeftRightCheck(false);
  matching.setLeftRightCheckThreshold(2);
  matching.setPairAgreement(0.3);
  matching.setRequirePairAgreement(true);
  const MatchedDisparity wanted = matchSoundly(matching, frames);
  TrinocularMatching copy(matching);
  EXPECT_EQ(copy.getReport().shots, 0u) << "not the report";
  EXPECT_TRUE(isSame(matchSoundly(copy, frames), wanted));
  TrinocularMatching assigned;
  assigned = copy;
  copy.setMaxDisparity(8);
  EXPECT_TRUE(isSame(matchSoundly(assigned, frames), wanted));
  EXPECT_FALSE(isSame(matchSoundly(copy, frames), wanted));
}

/** FNV checksum of the complete result. */
template <typename Value>
void
addTo(std::uint64_t& sum, const std::vector<Value>& values)
{
  const auto* const bytes = reinterpret_cast<const unsigned char*>(values.data());
  for (std::size_t i = 0; i < values.size() * sizeof(Value); ++i)
    sum = (sum ^ bytes[i]) * 0x100000001b3u;
}

std::string
checksums()
{
  std::string text = "checksums";
  const TrinocularRig rig = syntheticRig(-0.1, 0.07);
  for (const int shots : {1, 2, 3, 6}) {
    const MatchedDisparity matched = matchSoundly(rig, mixedShots(rig, shots));
    std::uint64_t sum = 0xcbf29ce484222325u;
    addTo(sum, matched.disparity.values);
    addTo(sum, matched.sigma);
    addTo(sum, matched.support);
    addTo(sum, matched.outcome);
    text += " " + std::to_string(sum);
  }
  return text;
}

/** Only run by the next test, in a separate process, because the variant is selected
 * once per process. */
TEST(TrinocularMatchingBytes, DISABLED_PrintsChecksums)
{
  std::cout << checksums() << std::endl;
}

TEST(TrinocularMatchingBytes, PlainAndWideInstructionsGiveTheSame)
{
#ifndef __x86_64__
  GTEST_SKIP() << "there are only the plain ones";
#endif
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string wanted = checksums();
  for (const char* asked : {"base", ""}) {
    RunSettings settings;
    settings.environment = {{"ACMAP_SIMD", asked}};
    const ToolRun run =
        runTool(self,
                {"--gtest_also_run_disabled_tests", "--gtest_filter=*PrintsChecksums"},
                settings);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.out.find(wanted), std::string::npos) << asked << '\n' << run.out;
  }
}

} // namespace
} // namespace pcl::acmap::test
