#include "command_line.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace pcl::acmap {
namespace {

using Words = std::vector<std::string>;

class CommandLine : public testing::Test {
protected:
  CommandLine()
  {
    app_.add_option("--max-edge", number_)->check(positiveNumber());
    app_.add_option("-o,--output", text_);
  }

  CLI::App app_;
  double number_ = 0;
  std::string text_;
};

TEST_F(CommandLine, OneDashAndUnderscoresAreRewritten)
{
  EXPECT_EQ(withDoubleDashes({"-max_edge", "1", "-max-edge=2", "--max_edge"}, app_),
            (Words{"--max-edge", "1", "--max-edge=2", "--max-edge"}));
}

TEST_F(CommandLine, OtherWordsStay)
{
  const Words words = {"-o", "x", "-1", "-", "--", "-max_edge", "a-b.pcd"};
  EXPECT_EQ(withDoubleDashes(words, app_), words);
  EXPECT_EQ(withDoubleDashes({"-unknown", "-3.5e-2"}, app_),
            (Words{"-unknown", "-3.5e-2"}));
}

TEST_F(CommandLine, CrossedNumbersAreTwoWithNothingElse)
{
  EXPECT_EQ(crossedNumbers("1024x768"), (std::array<int, 2>{1024, 768}));
  EXPECT_EQ(crossedNumbers("-3x0"), (std::array<int, 2>{-3, 0}));
  for (const std::string bad :
       {"", "x", "9", "9x", "x6", "9x6x", "9 x6", "9X6", "9.5x6", "9x99999999999"})
    EXPECT_FALSE(crossedNumbers(bad)) << bad;
}

TEST_F(CommandLine, OnlyFiniteNumbersAboveZeroAreLengths)
{
  for (const std::string bad : {"0", "-1", "nan", "inf", "1x", "", "1e999"})
    EXPECT_THROW(app_.parse(Words{bad, "--max-edge"}), CLI::ParseError) << bad;
  EXPECT_NO_THROW(app_.parse(Words{"0.25", "--max-edge"}));
  EXPECT_EQ(number_, 0.25);
}

} // namespace
} // namespace pcl::acmap
