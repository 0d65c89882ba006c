#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/folder_entries.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

TEST(FolderEntries, StandInTheOrderOfTheirNames)
{
  const TemporaryFolder folder;
  EXPECT_TRUE(folderEntries(folder.path("")).empty());
  for (const char* name : {"b", "a 2", ".hidden", "ä", "B"})
    folder.write(name, "");
  std::vector<std::string> names;
  for (const std::filesystem::path& entry : folderEntries(folder.path("")))
    names.push_back(entry.filename().string());
  EXPECT_EQ(names, (std::vector<std::string>{".hidden", "B", "a 2", "b", "ä"}));
}

TEST(FolderEntries, OfWhatIsNoFolderAreRefused)
{
  const TemporaryFolder folder;
  EXPECT_THROW(folderEntries(folder.path("none")), InputFileException);
  EXPECT_THROW(folderEntries(folder.write("file", "")), InputFileException);
}

} // namespace
} // namespace pcl::acmap::test
