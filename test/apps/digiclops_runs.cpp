#include "digiclops_runs.h"

#include "temporary_folder.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace pcl::acmap::test {

ToolRun
runGrabber(const std::vector<std::string>& arguments, const RunSettings& settings)
{
  return runTool(ACMAP_DIGICLOPS_GRABBER, arguments, settings);
}

void
expectGrabberFails(const ToolRun& run, int exit_code, const std::string& word)
{
  EXPECT_EQ(run.exit_code, exit_code) << "signal " << run.signal << "\n" << run.err;
  EXPECT_EQ(run.out, "");
  const std::string lines = run.err.substr(0, run.err.size() - !run.err.empty());
  const std::size_t begin = lines.rfind('\n') + 1; // 0 for a single line
  EXPECT_THAT(lines.substr(begin), testing::StartsWith("pcl_digiclops_grabber: "));
  EXPECT_THAT(lines.substr(begin), testing::HasSubstr(word));
}

std::vector<std::string>
namesIn(const std::string& folder)
{
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void
expectSameFiles(const std::string& folder, const std::string& as)
{
  const std::vector<std::string> names = namesIn(as);
  EXPECT_FALSE(names.empty()) << as;
  EXPECT_EQ(namesIn(folder), names);
  for (const std::string& name : names)
    EXPECT_TRUE(contentOf(folder + "/" + name) == contentOf(as + "/" + name)) << name;
}

} // namespace pcl::acmap::test
