#include "compact_mapping/killed_runs.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

/** \brief Number of a process that has ended. */
std::string
deadProcess()
{
  const pid_t process = fork();
  if (process == 0)
    _exit(0);
  waitpid(process, nullptr, 0);
  return std::to_string(process);
}

TEST(KilledRuns, OnlyWhatTheyLeftIsRemoved)
{
  const TemporaryFolder folder;
  const std::string dead = deadProcess();
  fs::create_directory(folder.path(".acmap.tmp-" + dead + "-0"));
  folder.write(".acmap.tmp-" + dead + "-0/map.json", "half");
  folder.write(".map.json.tmp-" + dead + "-12", "half");
  const std::vector<std::string> others = {".acmap.tmp-" + std::to_string(getpid()) +
                                               "-0",
                                           ".git",
                                           ".acmap.tmp-",
                                           ".acmap.tmp-" + dead,
                                           ".acmap.tmp-" + dead + "-",
                                           ".acmap.tmp-" + dead + "-0.bak",
                                           ".acmap.tmp-0-0",
                                           ".acmap.tmp--1-0",
                                           ".acmap.tmp-99999999999999999999-0",
                                           "acmap.tmp-" + dead + "-0"};
  for (const std::string& name : others)
    folder.write(name, "mine");
  removeLeftovers(folder.path(""));
  EXPECT_EQ(folder.count(), static_cast<std::ptrdiff_t>(others.size()));
  for (const std::string& name : others)
    EXPECT_TRUE(fs::exists(folder.path(name))) << name;
  removeLeftovers(folder.path("none"));
}

} // namespace
} // namespace pcl::acmap::test
