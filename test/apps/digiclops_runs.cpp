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
