#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/output_file.h>
#include <pcl/core/output_group.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

namespace pcl::acmap {
namespace {

/** Returns a function that writes a text to a path, like a saver. */
std::function<void(const std::string&)>
saving(const std::string& text)
{
  return [text](const std::string& place) {
    OutputFile file(place);
    file.write(text.data(), text.size());
    file.commit();
  };
}

class OutputGroupTest : public testing::Test {
protected:
  test::TemporaryFolder folder_;
  std::string a_ = folder_.path("a.json");
  std::string b_ = folder_.path("b.pcd");
};

TEST_F(OutputGroupTest, FilesAppearTogether)
{
  OutputGroup outputs;
  outputs.write(a_, saving("1"));
  outputs.write(b_, [&](const std::string& place) {
    EXPECT_EQ(place.substr(place.size() - 4), ".pcd");
    EXPECT_FALSE(std::filesystem::exists(a_));
    saving("2")(place);
  });
  EXPECT_FALSE(std::filesystem::exists(b_));
  outputs.commit();
  EXPECT_EQ(test::contentOf(a_), "1");
  EXPECT_EQ(test::contentOf(b_), "2");
  EXPECT_EQ(folder_.count(), 2);
}

TEST_F(OutputGroupTest, AFailureLeavesTheOldOnes)
{
  folder_.write("a.json", "old");
  EXPECT_THAT(
      [&] {
        OutputGroup outputs;
        outputs.write(a_, saving("new"));
        outputs.write(b_, [](const std::string& place) {
          saving("half")(place);
          throw OutputFileException(place + ": disk full");
        });
      },
      testing::ThrowsMessage<OutputFileException>(
          testing::HasSubstr(b_ + ": disk full")));
  EXPECT_EQ(test::contentOf(a_), "old");
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(OutputGroupTest, LinksAndPermissionsStay)
{
  namespace fs = std::filesystem;
  folder_.write("real.json", "old");
  fs::permissions(folder_.path("real.json"), fs::perms(0640));
  fs::create_symlink("real.json", a_);
  OutputGroup outputs;
  outputs.write(a_, saving("new"));
  outputs.commit();
  EXPECT_TRUE(fs::is_symlink(a_));
  EXPECT_EQ(test::contentOf(folder_.path("real.json")), "new");
  EXPECT_EQ(fs::status(a_).permissions(), fs::perms(0640));
}

TEST_F(OutputGroupTest, AProtectedFileIsRefused)
{
  if (geteuid() == 0)
    GTEST_SKIP() << "the superuser may write everywhere";
  folder_.write("a.json", "old");
  std::filesystem::permissions(a_, std::filesystem::perms(0400));
  OutputGroup outputs;
  EXPECT_THROW(outputs.write(a_, saving("new")), OutputFileException);
}

} // namespace
} // namespace pcl::acmap
