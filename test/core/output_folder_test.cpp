#include "messages.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/output_file.h>
#include <pcl/core/output_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void
write(const std::string& path, const std::string& content)
{
  std::ofstream(path) << content;
}

std::string
faultOfCommit(OutputFolder& folder)
{
  return messageOf<OutputFileException>([&] { folder.commit(); }, "no fault");
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

TEST(OutputFolder, ANewFolderAppearsAsAWhole)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("new/");
  {
    OutputFolder output(path);
    write(output.path("a"), "gone");
    EXPECT_THAT(output.names(), IsEmpty());
  }
  EXPECT_EQ(folder.count(), 0);
  OutputFolder output(path);
  write(output.path("a"), "new");
  EXPECT_TRUE(fs::is_empty(path));
  output.commit();
  EXPECT_EQ(contentOf(path + "a"), "new");
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputFolder, WhatOthersPutIntoTheNewFolderStays)
{
  const TemporaryFolder folder;
  OutputFolder output(folder.path("new"));
  write(output.path("a"), "new");
  folder.write("new/theirs", "stays");
  output.commit();
  EXPECT_EQ(contentOf(folder.path("new/a")), "new");
  EXPECT_EQ(contentOf(folder.path("new/theirs")), "stays");
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputFolder, LeftoversOfKilledRunsAreRemoved)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("out");
  // left by a run that created the folder, by one that found it, and by one of a file
  // in it
  for (const char* const name : {".out.acmap-unfinished-0/out",
                                 "out/.acmap-unfinished-1",
                                 "out/.a.acmap-unfinished-0"}) {
    fs::create_directories(folder.path(name));
    folder.write(std::string(name) + "/a", "half");
  }
  const OutputFolder output(path);
  EXPECT_THAT(output.names(), IsEmpty());
  EXPECT_EQ(folder.count(), 1);
  EXPECT_EQ(std::distance(fs::directory_iterator(path), {}), 1); // only its own entry
}

TEST(OutputFolder, FaultsNameThePlaceThatTheUserKnows)
{
  const TemporaryFolder folder;
  for (const char* const name : {"new", "old"}) {
    const std::string path = folder.path(name);
    if (path.back() == 'd')
      fs::create_directory(path);
    const OutputFolder output(path);
    EXPECT_EQ(shownPath(output.path("a")), path + "/a");
    fs::create_directory(output.path("a"));
    EXPECT_THAT([&] { OutputFile file(output.path("a")); },
                testing::ThrowsMessage<OutputFileException>(path + "/a: is a folder"));
  }
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
