#include "command_line.h"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
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

TEST_F(CommandLine, MisspeltOptionsAreSuggestedInTheSpellingOfTheUser)
{
  app_.add_option("--consolidate", number_);
  app_.add_option("--min-depth", number_);
  app_.add_option("--max-depth", number_);
  const auto meant = [&](const std::string& word) {
    const std::string fault = unknownOptionFault({word}, app_);
    const std::string asks = "did you mean ";
    const std::size_t at = fault.find(asks);
    EXPECT_EQ(fault.rfind(word.substr(0, word.find('=')), 0), 0u) << fault;
    return at == std::string::npos ? "" : fault.substr(at + asks.size());
  };
  EXPECT_EQ(meant("--consolidat"), "--consolidate?");
  EXPECT_EQ(meant("--consoildate=0.1"), "--consolidate?");
  EXPECT_EQ(meant("--Consolidate"), "--consolidate?");
  EXPECT_EQ(meant("-max_edg"), "-max_edge?");
  EXPECT_EQ(meant("--max_edg"), "--max_edge?");
  EXPECT_EQ(meant("--ot"), "") << "what is so short may be anything";
  EXPECT_EQ(meant("--out"), "--output?");
  EXPECT_EQ(meant("--edge"), "--max-edge?");
  EXPECT_EQ(meant("--max-edge-length"), "--max-edge?");
  EXPECT_EQ(meant("--depth"), "--max-depth or --min-depth?");
  EXPECT_EQ(meant("--nonsense"), "");
}

TEST_F(CommandLine, WordsThatAreNoOptionsAreNoMisspeltOnes)
{
  EXPECT_EQ(unknownOptionFault({"max-edge", "-1", "-.5", "--", "-", ""}, app_), "");
  EXPECT_EQ(unknownOptionFault({}, app_), "");
  const std::string fault = unknownOptionFault({"a.pcd", "--a-word", "--b-word"}, app_);
  EXPECT_NE(fault.find("--a-word"), std::string::npos) << fault;
  EXPECT_NE(fault.find("--b-word"), std::string::npos) << fault;
}

TEST_F(CommandLine, ChoicesAreNamedInHelpAndInMessages)
{
  enum class Fruit { Pear, Apple };
  Fruit fruit = Fruit::Apple;
  addChoice<Fruit>(app_,
                   "--fruit",
                   fruit,
                   {{"pear", Fruit::Pear}, {"apple", Fruit::Apple}},
                   "what to eat");
  EXPECT_NE(app_.help().find("one of pear, apple; what to eat"), std::string::npos);
  EXPECT_EQ(app_.get_option("--fruit")->get_default_str(), "apple");
  app_.parse(Words{"pear", "--fruit"});
  EXPECT_EQ(fruit, Fruit::Pear);
  EXPECT_THAT(
      [&] {
        app_.parse(Words{"plum", "--fruit"});
      },
      testing::ThrowsMessage<CLI::ParseError>(
          testing::StrEq("--fruit: plum is not one of pear, apple")));
  EXPECT_EQ(fruit, Fruit::Pear);
}

TEST_F(CommandLine, UsageTellsWhatIsNeeded)
{
  CLI::App app("Tests.", "pcl_test");
  std::string in, more, out, rig;
  app.add_option("input", in)->type_name("IN.ply")->required();
  app.add_option("more", more)->type_name("MORE");
  app.add_option("-o,--output", out)->type_name("OUT_DIR")->required();
  app.add_option("--rig", rig)->type_name("RIG.yaml");
  EXPECT_EQ(usageOf(app), "pcl_test IN.ply [MORE] --output OUT_DIR [OPTIONS]");
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
