#include "ugly_page.h"
#include "virtual_display.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace pcl::acmap::test {
/** For gtest, which would otherwise print the bytes. */
void
PrintTo(const UglyTool& tool, std::ostream* to)
{
  *to << tool.name;
}

namespace {

class UglyMatrix : public testing::TestWithParam<UglyTool> {};

TEST_P(UglyMatrix, GivesWhatThePageSays)
{
  const UglyTool& tool = GetParam();
  const VirtualDisplay display;
  if (tool.draws && !display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  const std::vector<UglyRun> runs = runCases(tool);
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (const std::string& fault : runs[i].faults)
      ADD_FAILURE() << nameOf(tool.cases[i].kind) << ", " << tool.cases[i].what << ": "
                    << fault << "\n"
                    << runs[i].err;
  const UglyColumn seen = columnOf(tool, runs);
  const UglyColumn said = columnIn(contentOf(ACMAP_ROBUSTNESS_PAGE), tool.name);
  EXPECT_EQ(said.list, seen.list) << "write_robustness_page writes the page anew";
  EXPECT_EQ(said.cells, seen.cells);
}

INSTANTIATE_TEST_SUITE_P(Tools,
                         UglyMatrix,
                         testing::ValuesIn(uglyTools()),
                         [](const auto& info) { return info.param.name; });

TEST(UglyPage, NoToolAndNoUglinessIsMissing)
{
  std::set<std::string> programs = {"acmap_paper_figures"}, tools;
  for (const auto& entry : std::filesystem::directory_iterator(ACMAP_APPS))
    if (entry.path().extension() == ".cpp")
      programs.insert(entry.path().stem().string());
  for (const UglyTool& tool : uglyTools()) {
    tools.insert(tool.name);
    std::set<Ugliness> kinds;
    for (const UglyCase& ugly : tool.cases)
      kinds.insert(ugly.kind);
    EXPECT_EQ(kinds.size(), uglinesses().size()) << tool.name;
  }
  EXPECT_EQ(tools, programs);
}

} // namespace
} // namespace pcl::acmap::test
