#include "messages.h"
#include "temporary_folder.h"

#include <pcl/core/output_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

template <typename Action>
std::string
faultOf(const Action& action)
{
  return messageOf<OutputFileException>(action);
}

void
save(const std::string& path, const std::string& content)
{
  OutputFile file(path);
  file.write(content.data(), content.size());
  file.commit();
}

TEST(OutputFile, isInPlaceOnlyOnceItIsWhole)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a file.ply", "old");
  {
    OutputFile file(path);
    file.write("new", 3);
    EXPECT_EQ(contentOf(path), "old");
    file.commit();
    EXPECT_EQ(contentOf(path), "new");
  }
  EXPECT_EQ(contentOf(path), "new");
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputFile, leavesTheOldFileWhenAnExceptionPasses)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a.ply", "old");
  try {
    OutputFile file(path);
    file.write("new", 3);
    throw std::runtime_error("in between");
  }
  catch (const std::runtime_error&) {
  }
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputFile, severalOfOneNameDoNotMix)
{
  const TemporaryFolder folder;
  OutputFile first(folder.path("a"));
  OutputFile second(folder.path("a"));
  first.write("first", 5);
  second.write("second", 6);
  second.commit();
  EXPECT_EQ(contentOf(folder.path("a")), "second");
  first.commit();
  EXPECT_EQ(contentOf(folder.path("a")), "first");
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputFile, namesWhyItCannotBeMade)
{
  const TemporaryFolder folder;
  const auto fault_of_saving = [](const std::string& path) {
    return faultOf([&] { save(path, "a"); });
  };
  const std::string missing = folder.path("no/such/folder/a.ply");
  EXPECT_THAT(fault_of_saving(missing), HasSubstr(missing + ": No such file"));
  EXPECT_THAT(fault_of_saving(folder.path("")), HasSubstr("is a folder"));
  EXPECT_THAT(fault_of_saving(folder.write("a", "b") + "/c"),
              HasSubstr("Not a directory"));
  EXPECT_THAT(fault_of_saving(""), HasSubstr("names no file"));
}

TEST(OutputFile, respectsPermissions)
{
  if (::geteuid() == 0)
    GTEST_SKIP() << "root may write anywhere";
  const TemporaryFolder folder;
  const std::string path = folder.write("a", "old");
  ::chmod(path.c_str(), 0400);
  EXPECT_THAT(faultOf([&] { save(path, "new"); }), HasSubstr("Permission denied"));
  ::chmod(folder.path("").c_str(), 0500);
  EXPECT_THAT(faultOf([&] { save(folder.path("b"), "new"); }),
              HasSubstr("Permission denied"));
  ::chmod(folder.path("").c_str(), 0700);
  EXPECT_EQ(contentOf(path), "old");
}

TEST(OutputFile, keepsPermissionsAndLinks)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a", "old");
  ::chmod(path.c_str(), 0640);
  std::filesystem::create_symlink("a", folder.path("link"));
  save(folder.path("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
  EXPECT_EQ(contentOf(path), "new");
  struct stat status;
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
}

TEST(OutputFile, takesLongNames)
{
  const TemporaryFolder folder;
  const std::string path = folder.path(std::string(250, 'a'));
  save(path, "new");
  EXPECT_EQ(contentOf(path), "new");
}

TEST(OutputFile, writesStraightIntoDevices)
{
  EXPECT_EQ(faultOf([] { save("/dev/null", "a"); }), "");
  EXPECT_THAT(faultOf([] { save("/dev/full", "a"); }), HasSubstr("No space left"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

/** Limits the size of files, so that writing fails as on a full disk. */
class FileLimit {
public:
  explicit FileLimit(rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }

  ~FileLimit()
  {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }

private:
  rlimit before_{};
};

TEST(OutputFile, leavesTheOldFileWhenTheDiskIsFull)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a.ply", "old");
  for (const std::size_t size : {1500U, 1000000U}) {
    const FileLimit limit(1000);
    EXPECT_THAT(faultOf([&] { save(path, std::string(size, 'a')); }),
                HasSubstr(path + ": File too large"));
  }
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(folder.count(), 1);
}

} // namespace
} // namespace pcl::acmap::test
