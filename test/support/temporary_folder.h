#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace pcl::acmap::test {

/** \brief A new folder that is removed with its contents by the destructor. */
class TemporaryFolder {
public:
  TemporaryFolder()
  {
    std::string name = testing::TempDir() + "acmap-test-XXXXXX";
    if (!::mkdtemp(name.data()))
      throw std::runtime_error("no temporary folder");
    path_ = name;
  }

  ~TemporaryFolder()
  {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }

  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder&
  operator=(const TemporaryFolder&) = delete;

  std::string
  path(const std::string& name) const
  {
    return (path_ / name).string();
  }

  /** \brief Writes a file and returns its path. */
  std::string
  write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  /** \brief Number of files and folders in the folder. */
  std::ptrdiff_t
  count() const
  {
    return std::distance(std::filesystem::directory_iterator(path_), {});
  }

private:
  std::filesystem::path path_;
};

inline std::string
contentOf(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

} // namespace pcl::acmap::test
