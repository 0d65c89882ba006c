#include "temporary_folder.h"

#include <pcl/core/run_times.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

namespace pcl::acmap {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/** Sets a variable of the environment, or removes it, until the end of a test. */
class Variable {
public:
  Variable(const char* name, const std::optional<std::string>& value)
  : name_(name)
  {
    if (const char* const before = std::getenv(name))
      before_ = before;
    set(value);
  }

  Variable(const Variable&) = delete;

  Variable&
  operator=(const Variable&) = delete;

  ~Variable()
  {
    set(before_);
  }

private:
  void
  set(const std::optional<std::string>& value)
  {
    if (value)
      setenv(name_, value->c_str(), 1);
    else
      unsetenv(name_);
  }

  const char* name_;
  std::optional<std::string> before_;
};

const RunTimes times = {{0, 0}, {0.25, 3}, {1, 12.5}};

TEST(RunMemory, KeepsTheLastRunOfEachKind)
{
  const TemporaryFolder folder;
  const Variable cache("XDG_CACHE_HOME", folder.path("cache"));
  EXPECT_TRUE(recallRunTimes("cloud").empty());
  rememberRunTimes("cloud", {{0, 0}, {1, 7}});
  rememberRunTimes("folder", {{0, 0}, {1, 9}});
  rememberRunTimes("cloud", times);
  EXPECT_EQ(recallRunTimes("cloud"), times);
  EXPECT_EQ(recallRunTimes("folder").back().second, 9);
  EXPECT_TRUE(recallRunTimes("bag").empty());
}

TEST(RunMemory, IsBelowTheHomeOfTheUserByDefault)
{
  const TemporaryFolder folder;
  const Variable cache("XDG_CACHE_HOME", "not/absolute");
  const Variable home("HOME", folder.path("home"));
  rememberRunTimes("cloud", times);
  EXPECT_EQ(recallRunTimes("cloud"), times);
  EXPECT_TRUE(fs::exists(folder.path("home") + "/.cache/acmap/run_times.json"));
}

TEST(RunMemory, WithoutAHomeThereIsNone)
{
  const Variable cache("XDG_CACHE_HOME", std::nullopt), home("HOME", std::nullopt);
  rememberRunTimes("cloud", times);
  EXPECT_TRUE(recallRunTimes("cloud").empty());
}

TEST(RunMemory, WhatCannotBeWrittenOrReadIsNone)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path("file")) << "no folder";
  {
    const Variable cache("XDG_CACHE_HOME", folder.path("file"));
    rememberRunTimes("cloud", times);
    EXPECT_TRUE(recallRunTimes("cloud").empty());
  }
  const Variable cache("XDG_CACHE_HOME", folder.path(""));
  fs::create_directories(folder.path("acmap"));
  for (const char* const content :
       {"",
        "{",
        "[1, 2]",
        R"({"cloud": 3})",
        R"({"cloud": [[0, 0], [0.5, 8], [0.4, 9], [1, 10]]})",
        R"({"cloud": [[0, 0], [1, 1e300]]})",
        R"({"cloud": [[0, 0], [1, -1]]})",
        R"({"cloud": [[0, 0], [0.5, 3]]})"}) {
    std::ofstream(folder.path("acmap/run_times.json")) << content;
    EXPECT_TRUE(recallRunTimes("cloud").empty()) << content;
    rememberRunTimes("cloud", times);
    EXPECT_EQ(recallRunTimes("cloud"), times) << "after " << content;
  }
}

} // namespace
} // namespace pcl::acmap
