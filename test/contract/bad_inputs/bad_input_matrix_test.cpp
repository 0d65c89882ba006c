#include "bad_case.h"
#include "repetitions.h"

#include <pcl/console/print.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

namespace pcl::acmap::test {

namespace {

const std::vector<BadCase>&
allCases()
{
  static const std::vector<BadCase> all = [] {
    std::vector<BadCase> cases;
    addCloudCases(cases);
    addRowCases(cases);
    addMapCases(cases);
    addViewCases(cases);
    return cases;
  }();
  return all;
}

/** The refusals of each kind of input by their sentence, with one case of each. */
using Sentences = std::map<std::string, std::map<std::string, std::string>>;

} // namespace

/** No class crashes, hangs, throws what is not PCL's, or is silent, and all refuse an input
 * of a kind in the same words. CI asks each seventh case, the long run all of them. */
TEST(BadInputMatrix, eachIsUsedToldOrRefusedInTheSameWords)
{
  console::setVerbosityLevel(console::L_ALWAYS);
  const char* const chosen = std::getenv("ACMAP_BAD_INPUT"); // a part of a name
  Sentences sentences;
  const auto stride = static_cast<std::size_t>(repetitions(7, 1));
  std::size_t run = 0, refused = 0;
  for (std::size_t i = 0; i < allCases().size(); ++i) {
    const BadCase& bad = allCases()[i];
    if (chosen ? bad.name.find(chosen) == std::string::npos : i % stride != 0)
      continue;
    const Ending ending = endingOf(bad);
    ++run;
    EXPECT_EQ(ending.fault, "") << bad.name;
    if (ending.refusal.empty())
      continue;
    ++refused;
    if (bad.answer == Answer::Refused || bad.fault == "number")
      sentences[bad.fault].emplace(sentenceOf(ending.refusal),
                                   bad.name + ": " + ending.refusal);
  }
  for (const auto& [fault, texts] : sentences) {
    std::ostringstream list;
    for (const auto& [sentence, example] : texts)
      list << "\n  " << example;
    EXPECT_EQ(texts.size(), 1U) << fault << list.str();
  }
  std::cout << run << " cases, of which " << refused << " were refused\n";
  EXPECT_GE(allCases().size(), 2000U);
  EXPECT_GT(run, 0U);
}

} // namespace pcl::acmap::test
