#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace pcl::acmap::test {

/** \brief Path of a file of the test data, which may be missing. The folder is given by
 * the environment variable ACMAP_TEST_DATA. */
inline std::filesystem::path
testDataPath(const std::string& relative)
{
  const char* folder = std::getenv("ACMAP_TEST_DATA");
  return folder ? std::filesystem::path(folder) / relative : std::filesystem::path();
}

/** \brief Does a file of the test data exist? */
inline bool
hasTestData(const std::string& relative)
{
  std::error_code error;
  return std::filesystem::is_regular_file(testDataPath(relative), error);
}

} // namespace pcl::acmap::test
