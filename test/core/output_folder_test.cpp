#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/output_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <set>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

void
write(const std::string& path, const std::string& content)
{
  std::ofstream(path) << content;
}

std::string
faultOfCommit(OutputFolder& folder)
{
  try {
    folder.commit();
  }
  catch (const OutputFileException& exception) {
    return exception.what();
  }
  return "no fault";
}

TEST(OutputFolder, FilesAppearAtTheCommit)
{
  const TemporaryFolder folder;
  folder.write("old", "stays");
  folder.write("a", "old");
  OutputFolder output(folder.path(""));
  write(output.path("a"), "new");
  EXPECT_EQ(contentOf(folder.path("a")), "old");
  EXPECT_THAT(output.names(), ElementsAre("a", "old"));
  output.commit();
  EXPECT_EQ(contentOf(folder.path("a")), "new");
  EXPECT_EQ(contentOf(folder.path("old")), "stays");
  EXPECT_EQ(folder.count(), 2);
}

TEST(OutputFolder, LeftoversOfAKilledRunStayHidden)
{
  const TemporaryFolder folder;
  // A run of the same number, as happens after a restart, may have been any of these.
  const std::string hidden = ".acmap.tmp-" + std::to_string(::getpid());
  std::set<std::string> leftovers = {hidden};
  for (int i = 0; i < 100; ++i)
    leftovers.insert(hidden + "-" + std::to_string(i));
  for (const std::string& name : leftovers) {
    fs::create_directory(folder.path(name));
    folder.write(name + "/leftover", "x");
  }
  OutputFolder output(folder.path(""));
  write(output.path("a"), "new");
  output.commit();
  EXPECT_FALSE(fs::exists(folder.path("leftover")));
  EXPECT_EQ(contentOf(folder.path("a")), "new");
  for (const std::string& name : leftovers)
    EXPECT_TRUE(fs::exists(folder.path(name + "/leftover"))) << name;
  EXPECT_EQ(folder.count(), 102);
}

TEST(OutputFolder, AFileOfTheHiddenNameIsPassedOver)
{
  const TemporaryFolder folder;
  for (int i = 0; i < 100; ++i)
    folder.write(".acmap.tmp-" + std::to_string(::getpid()) + "-" + std::to_string(i),
                 "x");
  OutputFolder output(folder.path(""));
  write(output.path("a"), "new");
  output.commit();
  EXPECT_EQ(folder.count(), 101);
}

TEST(OutputFolder, TwoAtATimeShareNothing)
{
  const TemporaryFolder folder;
  OutputFolder first(folder.path(""));
  {
    OutputFolder second(folder.path(""));
    EXPECT_NE(first.path("a"), second.path("a"));
    write(first.path("a"), "of the first");
    write(second.path("b"), "of the second");
    second.commit();
    EXPECT_FALSE(fs::exists(folder.path("a")));
  }
  first.commit();
  EXPECT_EQ(contentOf(folder.path("a")), "of the first");
  EXPECT_EQ(contentOf(folder.path("b")), "of the second");
  EXPECT_EQ(folder.count(), 2);
}

TEST(OutputFolder, FilesThatAreGoneAreNoticed)
{
  const TemporaryFolder folder;
  OutputFolder output(folder.path(""));
  write(output.path("a"), "new");
  fs::remove_all(output.path(""));
  EXPECT_THAT(faultOfCommit(output), HasSubstr(folder.path("") + ": No such file"));
}

} // namespace
} // namespace pcl::acmap::test
