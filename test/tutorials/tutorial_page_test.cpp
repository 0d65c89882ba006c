#include "tutorial_page.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using Kind = TutorialStep::Kind;

const std::string picture = "![Walls](../pictures/tutorials/walls.png)\n";
const std::string script = "```sh\ntrue\n```\n";

TEST(TutorialPage, HasItsBlocksInTheirOrder)
{
  const TutorialPage page = parseTutorial("# A page\n\n"
                                          "`a.cpp`:\n\n```cpp\nint\n\nmain ()\n```\n"
                                          "Then\n```sh\nb  # c\nd\n```\nwhich tells\n"
                                          "```text\n1 e\n```\n" +
                                          picture);
  ASSERT_EQ(page.steps.size(), 3);
  EXPECT_EQ(page.steps[0].kind, Kind::File);
  EXPECT_EQ(page.steps[0].name, "a.cpp");
  EXPECT_EQ(page.steps[0].text, "int\n\nmain ()\n");
  EXPECT_EQ(page.steps[1].kind, Kind::Script);
  EXPECT_EQ(page.steps[1].text, "b  # c\nd\n");
  EXPECT_EQ(page.steps[1].line, 11);
  EXPECT_EQ(page.steps[2].kind, Kind::Output);
  EXPECT_EQ(page.steps[2].text, "1 e\n");
}

TEST(TutorialPage, TakesTheIndentOfListItemsAway)
{
  const TutorialPage page =
      parseTutorial("1. Do\n\n   ```sh\n   a \\\n     b\n   ```\n" + picture);
  ASSERT_EQ(page.steps.size(), 1);
  EXPECT_EQ(page.steps[0].text, "a \\\n  b\n");
}

TEST(TutorialPage, NamesThePicturesOfTutorialsAlone)
{
  const TutorialPage page =
      parseTutorial(script + "| ![a](../pictures/tutorials/a.png) | "
                             "![b](../pictures/tutorials/b.png) |\n"
                             "![c](../pictures/c.png)\n");
  EXPECT_THAT(page.pictures, ElementsAre("a.png", "b.png"));
}

TEST(TutorialPage, LeavesWhatIsForTheReaderAlone)
{
  const TutorialPage page =
      parseTutorial(script + "```console\nsudo reboot\n```\n" + picture);
  EXPECT_EQ(page.steps.size(), 1);
}

TEST(TutorialPage, RefusesWhatNobodyWouldFollow)
{
  const std::string nameless = "Write\n\n```cpp\nint x;\n```\n";
  const std::string no_language = "```\ntrue\n```\n";
  const std::string output_of_nothing = "```text\n1\n```\n";
  const std::string open = "```sh\ntrue\n";
  for (const std::string& block : {nameless, no_language, output_of_nothing, open})
    EXPECT_THROW(parseTutorial(picture + block + "\n"), std::runtime_error) << block;
  EXPECT_THROW(parseTutorial(script), std::runtime_error);
  EXPECT_THROW(parseTutorial(picture), std::runtime_error);
}

} // namespace
} // namespace pcl::acmap::test
