#include "temporary_folder.h"
#include "tool_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace pcl::acmap::test {
namespace {

using Run = ToolRun (*)(const std::vector<std::string>&, const RunSettings&);

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string mapping_tool = std::string(ACMAP_BIN) + "/pcl_compact_mapping";

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
/** No line is longer than the width, counted in characters. */
void
expectNarrow(const std::string& text, std::size_t width)
{
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(std::count_if(
                  line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }),
              static_cast<std::ptrdiff_t>(width))
        << line;
}

/** The examples of a help use options that it has. */
void
expectKnownOptions(const std::string& help)
{
  const std::size_t begin = help.find("\nExamples:\n");
  ASSERT_NE(begin, std::string::npos) << help;
  const std::size_t end = help.find("\n\n", begin);
  static const std::regex option("--[a-z0-9][a-z0-9-]*");
  const std::string examples = help.substr(begin, end - begin), rest = help.substr(end);
  for (std::sregex_iterator one(examples.begin(), examples.end(), option), last;
       one != last;
       ++one)
    EXPECT_THAT(rest, HasSubstr(one->str()));
}

/** The environment of a run with so many columns. */
RunSettings
columns(const char* count)
{
  RunSettings settings;
  settings.environment = {{"COLUMNS", count}};
  return settings;
}

TEST(Help, FitsTheColumnsThatThereAre)
{
  for (const char* count : {"50", "80", "132"}) {
    const ToolRun run = runTool(mapping_tool, {"--help", "all"}, columns(count));
    expectNarrow(run.out, std::stoul(count));
  }
  const ToolRun wild = runTool(mapping_tool, {"--help"}, columns("-7"));
  EXPECT_EQ(wild.exit_code, 0);
  EXPECT_THAT(wild.out, HasSubstr("--output"));
}

TEST(Help, ShowsCommonOptionsOrThoseOfASubject)
{
  const auto help = [](std::vector<std::string> words) {
    words.insert(words.begin(), "--help");
    return runTool(mapping_tool, words).succeeded().out;
  };
  const std::string common = help({}), all = help({"all"}), stereo = help({"stereo"});
  for (const char* option : {"--paper", "--as-recorded", "--up", "--output"})
    EXPECT_THAT(common, HasSubstr(option));
  EXPECT_THAT(common, Not(HasSubstr("--min-correlation")));
  EXPECT_THAT(common, HasSubstr("--help all"));
  EXPECT_THAT(all, HasSubstr("--min-correlation"));
  EXPECT_THAT(stereo, HasSubstr("--min-correlation"));
  EXPECT_THAT(stereo, Not(HasSubstr("--no-rectification")));
  EXPECT_LT(common.size(), all.size() / 2);
  EXPECT_EQ(help({"cloud.ply"}), common);
}

TEST(Help, IsAPageOfTheManual)
{
  const std::string page = runTool(mapping_tool, {"--help", "man"}).out;
  EXPECT_THAT(page, StartsWith(".TH pcl_compact_mapping 1"));
  EXPECT_THAT(page, HasSubstr("\n.SH SYNOPSIS\n"));
  EXPECT_THAT(page, HasSubstr("\\-\\-output"));
}

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
    const std::string help = runTool(program, {"--help", "all"}).out;
    expectNarrow(help, 80);
    expectKnownOptions(help);
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
