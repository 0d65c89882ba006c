#include "json_file.h"
#include "run_tool.h"
#include "screen.h"
#include "temporary_folder.h"
#include "virtual_display.h"

#include <pcl/acquisition/random_line_pattern.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <future>
#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

ToolRun
runPattern(const std::vector<std::string>& arguments, const RunSettings& settings = {})
{
  return runTool(ACMAP_LINE_PATTERN, arguments, settings);
}

class LinePattern : public testing::Test {
protected:
  std::vector<std::string>
  arguments(const std::vector<std::string>& more = {}) const
  {
    return joined({output_, "--size", "160x120"}, more);
  }

  TemporaryFolder folder_;
  std::string output_ = folder_.path("patterns");
};

TEST_F(LinePattern, WritesWhatTheClassGenerates)
{
  const ToolRun run = runPattern({output_,
                                  "--patterns",
                                  "3",
                                  "--lines",
                                  "150",
                                  "--min-angle",
                                  "15",
                                  "--seed",
                                  "9"})
                          .succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("3, 1024 x 768 px, 150 lines each"));
  RandomLinePattern pattern;
  pattern.setNumberOfLines(150);
  pattern.setMinimumAngle(15 * 3.14159265358979323846 / 180);
  pattern.setSeed(9);
  const auto report = jsonOfFile(output_ + "/report.json");
  ASSERT_EQ(report["patterns"].size(), 3u);
  double coverage = 0;
  for (std::uint32_t index = 0; index < 3; ++index) {
    const std::string name = "pattern_0" + std::to_string(index) + ".png";
    const RgbImage image = loadRgbImage(output_ + "/" + name);
    EXPECT_EQ(image.width, 1024);
    EXPECT_EQ(image.values, pattern.generate(index).values);
    EXPECT_EQ(report["patterns"][index]["file"], name);
    EXPECT_EQ(report["patterns"][index]["coverage"], pattern.getReport().coverage);
    EXPECT_EQ(report["patterns"][index]["redraws"], pattern.getReport().redraws);
    coverage += pattern.getReport().coverage / 3;
  }
  EXPECT_NEAR(report["coverage"], coverage, 1e-12);
  EXPECT_EQ(report["lines"], 150);
  EXPECT_EQ(report["seed"], 9);
  EXPECT_GE(report["seconds"]["draw"], 0.0);
}

TEST_F(LinePattern, HasTenPatternsByDefaultAndOneInAPicture)
{
  runPattern(arguments()).succeeded();
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(output_), {}), 11);
  const std::string folder = output_;
  output_ = folder_.path("one.PNG");
  runPattern(arguments()).succeeded();
  EXPECT_EQ(contentOf(output_), contentOf(folder + "/pattern_00.png"));
  EXPECT_EQ(folder_.count(), 2); // no report next to the picture
  const std::string report = folder_.path("r.json");
  runPattern(arguments({"--grey", "--report", report})).succeeded();
  const RgbImage grey = loadRgbImage(output_);
  for (std::size_t i = 0; i < grey.values.size(); i += 3)
    ASSERT_EQ(grey.values[i], grey.values[i + 2]);
  EXPECT_EQ(jsonOfFile(report)["patterns"][0]["file"], output_);
}

TEST_F(LinePattern, TellsPatternsThatRepeatThemselves)
{
  const ToolRun run = runPattern(arguments({"--patterns", "1", "--lines", "1"}));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("pattern 0 repeats itself"));
  EXPECT_THAT(run.out, HasSubstr("redrawn:     16"));
}

TEST_F(LinePattern, HelpTellsUnitsAndDefaults)
{
  const ToolRun help = runPattern({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word :
       {"pixels", "degrees", "seconds", "1024x768]", " 10]", " 200]", "Exit codes"})
    EXPECT_THAT(help.out, HasSubstr(word));
}

TEST_F(LinePattern, NonsenseIsRefused)
{
  expectRefused(runPattern({}), 2, "output");
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"--patterns", "0"},
                                             {"--patterns", "1001"},
                                             {"--patterns", "-3"},
                                             {"--lines", "0"},
                                             {"--lines", "10001"},
                                             {"--lines", "many"},
                                             {"--min-angle", "-1"},
                                             {"--min-angle", "86"},
                                             {"--min-angle", "nan"},
                                             {"--seed", "-1"},
                                             {"--seed", "1.5"},
                                             {"--monitor", "0"},
                                             {"--hold", "1"},
                                             {"--show", "--hold", "0"},
                                             {"--show", "--hold", "nan"},
                                             {"--show", "--monitor", "-1"}})
    expectRefused(runPattern(arguments(words)), 2, "--help");
  for (const std::string size : {"",
                                 "x",
                                 "640",
                                 "640x",
                                 "x480",
                                 "640x480x3",
                                 "axb",
                                 "0x0",
                                 "-640x480",
                                 "15x99",
                                 "99999999999x16",
                                 "640 x 480"})
    expectRefused(runPattern({output_, "--size", size}), 2, "--help");
  output_ = folder_.path("one.png");
  expectRefused(runPattern(arguments({"--patterns", "2"})), 2, "holds one pattern");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(LinePattern, PlacesThatCannotBeAreRefused)
{
  expectRefused(runPattern({folder_.path("none/p")}), 5, "none/p");
  expectRefused(runPattern({folder_.path("none/p.png")}), 5, "none");
  expectRefused(runPattern({folder_.write("file", "mine")}), 5, "is a file");
  expectRefused(runPattern(arguments({"--report", folder_.path("r.txt")})), 5, ".json");
  EXPECT_EQ(folder_.count(), 1);
  runPattern(arguments({"--patterns", "2"})).succeeded();
  const std::string before = contentOf(output_ + "/pattern_01.png");
  expectRefused(runPattern(arguments({"--seed", "3"})), 5, "already holds pattern_0");
  EXPECT_EQ(contentOf(output_ + "/pattern_01.png"), before);
}

TEST_F(LinePattern, FullDiskAndInterruptionLeaveNothing)
{
  RunSettings full;
  full.file_size_limit = 3000;
  expectRefused(runPattern(arguments(), full), 5, "pattern_00.png");
  RunSettings interrupted;
  interrupted.interrupt_after = 0.5;
  expectRefused(runPattern({output_, "--patterns", "1000"}, interrupted), 130, "");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(LinePattern, NeedsADisplayOnlyToShow)
{
  RunSettings none;
  none.environment = {{"DISPLAY", std::nullopt}};
  expectRefused(runPattern(arguments({"--show"}), none), 1, "DISPLAY");
  EXPECT_EQ(folder_.count(), 0);
  EXPECT_EQ(runPattern(arguments(), none).exit_code, 0);
}

class ShownLinePattern : public LinePattern {
protected:
  void
  SetUp() override
  {
    if (!display_.exists())
      GTEST_SKIP() << "Xvfb is not installed";
  }

  /** \brief Waits until the screen shows an image. Returns false after a timeout. */
  static bool
  comesToShow(const RgbImage& image)
  {
    for (int i = 0; i < 200; ++i) {
      if (shootScreen().values == image.values)
        return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

  VirtualDisplay display_{"160x120x24"};
};

TEST_F(ShownLinePattern, ShowsEachPatternInTurn)
{
  auto running = std::async(std::launch::async, [&] {
    return runPattern(arguments({"--patterns", "2", "--show", "--hold", "1.5"}));
  });
  RandomLinePattern pattern;
  pattern.setSize(160, 120);
  EXPECT_TRUE(comesToShow(pattern.generate(0)));
  EXPECT_TRUE(comesToShow(pattern.generate(1)));
  const ToolRun run = running.get();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("160 x 120 px"));
  const auto report = jsonOfFile(output_ + "/report.json");
  EXPECT_EQ(report["monitor"]["width"], 160);
  EXPECT_GE(report["seconds"]["draw"], 3.0);
}

TEST_F(ShownLinePattern, InterruptionEndsTheShow)
{
  RunSettings interrupted;
  interrupted.interrupt_after = 0.5;
  expectRefused(
      runPattern(arguments({"--show", "--hold", "3600"}), interrupted), 130, "");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(ShownLinePattern, OtherSizesAndMonitorsAreTold)
{
  expectRefused(runPattern(arguments({"--show", "--monitor", "3"})), 2, "monitor = 3");
  const ToolRun run =
      runPattern({output_, "--patterns", "1", "--show", "--hold", "0.01"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("the patterns 1024 x 768 px: they are shown scaled"));
}

} // namespace
} // namespace pcl::acmap::test
