#include "trial_page.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string head = "## A title\n\nText.\n\n| a | b | c |\n|---|---|---|\n";

TEST(TrialPage, HasRowsUnderHeadings)
{
  const auto sections = parseTrial(
      head + "| Why? | `tool a --b` | exit 2, says `--c` `d e` |\n" +
      "| How? | `tool` | exit 0, prints `1`, says `w`, writes `f` |\n\n" + head);
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[0].title, "A title");
  EXPECT_THAT(sections[1].rows, IsEmpty());
  ASSERT_EQ(sections[0].rows.size(), 2u);
  const TrialRow& first = sections[0].rows[0];
  EXPECT_EQ(first.line, 7);
  EXPECT_EQ(first.question, "Why?");
  EXPECT_EQ(first.command, "tool a --b");
  EXPECT_EQ(first.exit_code, 2);
  EXPECT_THAT(first.says, ElementsAre("--c", "d e"));
  EXPECT_THAT(first.prints, IsEmpty());
  const TrialRow& second = sections[0].rows[1];
  EXPECT_EQ(second.exit_code, 0);
  EXPECT_THAT(second.prints, ElementsAre("1"));
  EXPECT_THAT(second.writes, ElementsAre("f"));
}

TEST(TrialPage, RefusesRowsThatNobodyCanTry)
{
  for (const char* row : {"| a | `b` |",
                          "| a | b | exit 0 |",
                          "| a | `b` | says `c` |",
                          "| a | `b` | exit |",
                          "| a | `b` | exit 0, tells `c` |",
                          "| a | `b` | exit 0 `c` |"})
    EXPECT_THROW(parseTrial(head + row + "\n"), std::runtime_error) << row;
  EXPECT_THROW(parseTrial("| a | b | c |\n|---|---|---|\n| a | `b` | exit 0 |\n"),
               std::runtime_error);
}

TEST(TrialPage, FindsTheCommandsOfAnotherPage)
{
  const std::string page = "```sh\nno\n```\n**Here.**\n\n```sh\na b   # c\n\nd\n```\n"
                           "```sh\nnor this\n```\n";
  EXPECT_THAT(commandsUnder("**Here.**", page), ElementsAre("a b", "d"));
  EXPECT_THROW(commandsUnder("**There.**", page), std::runtime_error);
}

} // namespace
} // namespace pcl::acmap::test
