#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace pcl::acmap::test {

/** \brief Place of a file of the test data; it need not be there. The folder is named by
 * the environment variable ACMAP_TEST_DATA. */
inline std::filesystem::path
testDataPath(const std::string& relative)
{
  const char* folder = std::getenv("ACMAP_TEST_DATA");
  return folder ? std::filesystem::path(folder) / relative : std::filesystem::path();
}

/** \brief Tells whether a file of the test data is there. */
inline bool
hasTestData(const std::string& relative)
{
  std::error_code error;
  return std::filesystem::is_regular_file(testDataPath(relative), error);
}

} // namespace pcl::acmap::test
