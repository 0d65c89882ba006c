#include "temporary_folder.h"
#include "tutorial_run.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TutorialPage
pageOf(const std::string& blocks)
{
  return parseTutorial(blocks + "![a](../pictures/tutorials/a.png)\n");
}

TEST(TutorialRun, WritesFilesAndRunsScriptsInTheFolder)
{
  const TemporaryFolder folder;
  followTutorial(pageOf("`a.txt`:\n```\n3 $HOME\n```\n```sh\ncat a.txt > b.txt\n```\n"),
                 folder.path(""));
  EXPECT_EQ(contentOf(folder.path("b.txt")), "3 $HOME\n");
}

TEST(TutorialRun, StopsAtTheFirstFailure)
{
  const TemporaryFolder folder;
  const auto follow = [&](const std::string& script) {
    return [&folder, page = pageOf("```sh\n" + script + "\ntouch reached\n```\n")] {
      followTutorial(page, folder.path(""));
    };
  };
  EXPECT_THAT(follow("ls no-such-file"),
              ThrowsMessage<std::runtime_error>(HasSubstr("no-such-file")));
  EXPECT_THAT(follow("echo $no_such_variable"),
              ThrowsMessage<std::runtime_error>(HasSubstr("line 1")));
  EXPECT_EQ(folder.count(), 0);
}

TEST(TutorialRun, WantsTheOutputThatThePageShows)
{
  const TemporaryFolder folder;
  const std::string tells = "```sh\necho planes: 15\necho file: a.json >&2\n```\n";
  const auto follow = [&](const std::string& output) {
    followTutorial(pageOf(tells + "```text\n" + output + "\n```\n"), folder.path(""));
  };
  EXPECT_NO_THROW(follow("planes:   16\nfile: a.json"));
  EXPECT_NO_THROW(follow("file: a.json"));
  EXPECT_THROW(follow("planes: 18"), std::runtime_error);
  EXPECT_THROW(follow("planes: fifteen"), std::runtime_error);
  EXPECT_THROW(follow("file: a.json\nplanes: 15"), std::runtime_error);
}

TEST(TutorialRun, ComparesNumbersLooselyAndWordsExactly)
{
  EXPECT_EQ(missingLine("a 1.00 mm\nb", "a 1.05 mm"), "");
  EXPECT_EQ(missingLine("a -1.00, 2", "a -1.05, 2"), "");
  EXPECT_EQ(missingLine("a -1.00, 2", "a 1.00, 2"), "a 1.00, 2");
  EXPECT_EQ(missingLine("a 1.00 mm", "a 1.00 m"), "a 1.00 m");
  EXPECT_EQ(missingLine("a 1.00 mm and more", "a 1.00 mm"), "a 1.00 mm");
  EXPECT_EQ(missingLine("0 faults", "1 faults"), "1 faults");
  EXPECT_EQ(missingLine("", "a"), "a");
}

} // namespace
} // namespace pcl::acmap::test
