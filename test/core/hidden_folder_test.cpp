#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/hidden_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <set>
#include <thread>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string first = ".a.ply.acmap-unfinished-0";
const std::string second = ".a.ply.acmap-unfinished-1";

TEST(HiddenFolder, GoesAwayWithItsOwner)
{
  const TemporaryFolder folder;
  {
    const HiddenFolder hidden(folder.path(""), "a.ply", "a.ply");
    EXPECT_EQ(hidden.path(), folder.path(first));
    folder.write(first + "/half", "x");
    const HiddenFolder other(folder.path(""), "a.ply", "a.ply");
    EXPECT_EQ(other.path(), folder.path(second));
    EXPECT_EQ(folder.count(), 2);
  }
  EXPECT_EQ(folder.count(), 0);
}

TEST(HiddenFolder, OfAKilledProcessIsRemovedByTheNextOne)
{
  const TemporaryFolder folder;
  const HiddenFolder alive(folder.path(""), "a.ply", "a.ply");
  const pid_t process = fork();
  if (process == 0) {
    const HiddenFolder killed(folder.path(""), "a.ply", "a.ply");
    folder.write(second + "/half", "x");
    raise(SIGKILL);
  }
  waitpid(process, nullptr, 0);
  EXPECT_EQ(folder.count(), 2);
  removeLeftoversOf(folder.path(""), "b.ply");
  EXPECT_EQ(folder.count(), 2);
  const HiddenFolder next(folder.path(""), "a.ply", "a.ply");
  EXPECT_TRUE(fs::is_empty(next.path()));
  EXPECT_EQ(folder.count(), 2);
}

TEST(HiddenFolder, NothingElseIsTakenForALeftover)
{
  const TemporaryFolder folder;
  const HiddenFolder alive(folder.path(""), "a.ply", "a.ply");
  fs::create_directory(folder.path(second));
  const std::set<std::string> others = {"a.ply.acmap-unfinished-0",
                                        ".acmap-unfinished-",
                                        ".acmap-unfinished-0.bak",
                                        ".acmap-unfinished-x",
                                        ".acmap-unfinished"};
  for (const std::string& name : others)
    fs::create_directory(folder.path(name));
  const std::string file = folder.write(".b.acmap-unfinished-0", "no folder of ours");
  fs::create_symlink("a.ply.acmap-unfinished-0", folder.path(".acmap-unfinished-0"));
  removeLeftoversIn(folder.path(""));
  EXPECT_FALSE(fs::exists(folder.path(second)));
  EXPECT_TRUE(fs::exists(alive.path()));
  EXPECT_TRUE(fs::exists(file));
  for (const std::string& name : others)
    EXPECT_TRUE(fs::exists(folder.path(name))) << name;
  EXPECT_EQ(folder.count(), static_cast<std::ptrdiff_t>(others.size()) + 3);
  removeLeftoversIn(folder.path("none"));
}

TEST(HiddenFolder, ManyAtATimeDoNotTakeEachOthers)
{
  const TemporaryFolder folder;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int round = 0; round < 200; ++round) {
        const HiddenFolder hidden(folder.path(""), "a.ply", "a.ply");
        const std::string file = hidden.path() / "file";
        std::ofstream(file) << "x";
        EXPECT_EQ(contentOf(file), "x");
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(folder.count(), 0);
}

TEST(HiddenFolder, ThatCannotBeMadeIsAFaultOfTheTarget)
{
  const TemporaryFolder folder;
  EXPECT_THAT(
      [&] {
        const HiddenFolder hidden(folder.path("none"), "a.ply", "as/the/user/wrote/it");
      },
      testing::ThrowsMessage<OutputFileException>(
          HasSubstr("as/the/user/wrote/it: No such file")));
}

TEST(HiddenFolder, IsNoPartOfAShownPath)
{
  EXPECT_EQ(shownPath("/x/" + first + "/a.ply"), "/x/a.ply");
  EXPECT_EQ(shownPath(first + "/a/b.ply"), "a/b.ply");
  EXPECT_EQ(shownPath("./o ut//b.ply"), "./o ut//b.ply");
  EXPECT_EQ(shownPath(""), "");
}

} // namespace
} // namespace pcl::acmap::test
