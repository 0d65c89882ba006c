#include "temporary_folder.h"
#include "tool_cases.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace pcl::acmap::test {
namespace {

using Run = ToolRun (*)(const std::vector<std::string>&, const RunSettings&);

class Usage : public testing::TestWithParam<Run> {};

TEST_P(Usage, HelpTellsUnitsAndExitCodesOnStdout)
{
  for (const char* spelling : {"--help", "-h", "-help"}) {
    const ToolRun run = GetParam()({spelling}, {});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    for (const char* word : {"Usage:", "metres", "--report", "--quiet", "Exit codes"})
      EXPECT_NE(run.out.find(word), std::string::npos) << word << "\n" << run.out;
  }
}

TEST_P(Usage, VersionIsTheProjects)
{
  const ToolRun run = GetParam()({"--version"}, {});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find(" (acmap) " ACMAP_VERSION "\n"), std::string::npos) << run.out;
  EXPECT_EQ(run.err, "");
}

TEST_P(Usage, NonsenseIsRefusedInOneLine)
{
  expectRefused(GetParam()({}, {}), 2, "--help");
  expectRefused(GetParam()({"a.pcd", "b.ply", "c.ply"}, {}), 2, "--help");
  expectRefused(GetParam()({"a.pcd", "b.ply", "--nonsense"}, {}), 2, "--nonsense");
  expectRefused(GetParam()({"a.pcd", "-scale", "x"}, {}), 2, "--scale");
  expectRefused(GetParam()({"a.pcd", "--scale"}, {}), 2, "--scale");
}

INSTANTIATE_TEST_SUITE_P(Tools,
                         Usage,
                         testing::Values(runSurface, runViewer, runPlanes));

/** No option, unit or default changes unnoticed. If ACMAP_REFRESH_FINGERPRINTS is set,
 * stores the help instead of comparing. */
TEST(StoredHelp, IsThatOfEachTool)
{
  namespace fs = std::filesystem;
  std::vector<std::string> names = {"acmap_paper_figures"};
  for (const auto& entry : fs::directory_iterator(ACMAP_TOOL_SOURCES))
    if (entry.path().extension() == ".cpp")
      names.push_back(entry.path().stem().string());
  std::size_t tools = 0;
  for (const std::string& name : names) {
    const std::string program = std::string(ACMAP_BIN) + "/" + name;
    if (!fs::exists(program))
      continue;
    ++tools;
    const std::string help = runTool(program, {"--help"}).out;
    const std::string path = std::string(ACMAP_STORED_HELP) + "/" + name + ".txt";
    if (std::getenv("ACMAP_REFRESH_FINGERPRINTS"))
      std::ofstream(path) << help;
    EXPECT_EQ(help, contentOf(path)) << name;
  }
  EXPECT_GT(tools, 3U);
}

TEST(SurfaceUsage, ValuesOutOfRangeAreRefusedBeforeAnyWork)
{
  const TemporaryFolder folder;
  const std::string input = folder.write("in.pcd", planePcd());
  const std::string output = folder.path("out.ply");
  const std::vector<std::vector<std::string>> nonsense = {
      {"--max-edge", "-1"},
      {"--max-edge", "nan"},
      {"--max-edge", "1e10"},
      {"--max-edge", "long"},
      {"--max-edge", "1", "-max_edge", "2"},
      {"--rule", "fast"},
      {"--rule", "Strict"},
      {"--threads", "-1"},
      {"--threads", "2.5"},
      {"--scale", "0"},
      {"--quiet=maybe"}};
  for (const auto& words : nonsense) {
    std::vector<std::string> arguments = joined({input, output}, words);
    SCOPED_TRACE(words[0] + " " + words.back());
    expectRefused(runSurface(arguments), 2, "--help");
  }
  expectRefused(runSurface({input, folder.path("out.vtk"), "--wall-depth"}), 2, ".ply");
  expectRefused(runSurface({input, output, "--max-edge", "-3"}),
                2,
                "--max-edge: maximum edge length = -3 is refused: it must be within "
                "[0, 1e+09] m (0 = automatic)");
  EXPECT_EQ(folder.count(), 1);
}

TEST(PlanesUsage, ValuesOutOfRangeAreRefusedBeforeAnyWork)
{
  const TemporaryFolder folder;
  const std::string input = folder.write("in.pcd", planePcd());
  const std::string output = folder.path("planes.json");
  const std::vector<std::vector<std::string>> nonsense = {{"--min-area", "-1"},
                                                          {"--min-area", "nan"},
                                                          {"--min-area", "much"},
                                                          {"--consolidate=-1"},
                                                          {"--consolidate=five"},
                                                          {"--labels"},
                                                          {"--paper=maybe"},
                                                          {"--threads", "-1"},
                                                          {"--scale", "0"}};
  for (const auto& words : nonsense) {
    std::vector<std::string> arguments = joined({input, output}, words);
    SCOPED_TRACE(words[0] + " " + words.back());
    expectRefused(runPlanes(arguments), 2, "--help");
  }
  expectRefused(
      runPlanes({input, output, "--paper", "--min-area", "1"}), 2, "--min-area");
  EXPECT_EQ(folder.count(), 1);
}

} // namespace
} // namespace pcl::acmap::test
