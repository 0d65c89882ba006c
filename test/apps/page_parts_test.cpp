#include "compact_mapping/page_seconds.h"
#include "compact_mapping/page_text.h"
#include "compact_mapping/report_page.h"
#include "html_checker.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

namespace pcl::acmap::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

constexpr const char* minus = "\xE2\x88\x92";

std::size_t
countOf(const std::string& text, const std::string& part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + part.size()))
    ++count;
  return count;
}

TEST(PageText, IsEscaped)
{
  EXPECT_EQ(htmlText("<b>&\"'.pcd"), "&lt;b&gt;&amp;&quot;&#39;.pcd");
  EXPECT_EQ(htmlText("K\xC3\xBC"
                     "che \xE2\x82\xAC \xF0\x9F\x8F\xA0"),
            "K\xC3\xBC"
            "che \xE2\x82\xAC \xF0\x9F\x8F\xA0");
  EXPECT_EQ(htmlText(""), "");
}

TEST(PageText, WhatIsNoTextIsReplaced)
{
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(htmlText("a\xFF"
                     "b"),
            "a" + replaced + "b");
  EXPECT_EQ(htmlText("\xC3"), replaced);                // truncated
  EXPECT_EQ(htmlText("\xC3<"), replaced + "&lt;");      // the next character is kept
  EXPECT_EQ(htmlText("\xC0\xBC"), replaced + replaced); // an overlong form of <
  // half of a surrogate pair
  EXPECT_EQ(htmlText("\xED\xA0\x80"), replaced + replaced + replaced);
  EXPECT_EQ(htmlText("\xF5\x80\x80\x80").substr(0, 3), replaced); // above U+10FFFF
  EXPECT_EQ(htmlText(std::string("\0\x1B\r\x7F", 4)),
            replaced + replaced + replaced + replaced);
}

TEST(PageText, CommandLinesCanBeGivenToAShell)
{
  EXPECT_EQ(shellText({"tool", "a/b-c.pcd", "--texel=0.02"}),
            "tool a/b-c.pcd --texel=0.02");
  EXPECT_EQ(shellText({"tool", "", "it's $HOME", "~"}), "tool '' 'it'\\''s $HOME' '~'");
}

TEST(PageText, NumbersHaveSensibleDigits)
{
  EXPECT_EQ(numberText(0), "0");
  EXPECT_EQ(numberText(138653), "138,653");
  EXPECT_EQ(numberText(14697233), "14,697,233");
  EXPECT_EQ(numberText(999.4), "999");
  EXPECT_EQ(numberText(999.6), "1,000");
  EXPECT_EQ(numberText(0.0213456), "0.0213");
  EXPECT_EQ(numberText(-1234.5), minus + std::string("1,234"));
  EXPECT_EQ(numberText(1e300), "1e+300");
  EXPECT_EQ(fixedText(-0.00004, 4), "0.0000");
  EXPECT_EQ(fixedText(-1234567.25, 1), minus + std::string("1,234,567.2"));
  EXPECT_GT(fixedText(std::numeric_limits<double>::max(), 2).size(), 309U);
}

TEST(PageText, SecondsAndBytesHaveUnits)
{
  EXPECT_EQ(secondsText(0.25), "0.25 s");
  EXPECT_EQ(secondsText(12.34), "12.3 s");
  EXPECT_EQ(secondsText(119.96), "2 min 00 s");
  EXPECT_EQ(secondsText(185), "3 min 05 s");
  EXPECT_EQ(bytesText(0), "0 bytes");
  EXPECT_EQ(bytesText(221316), "221 kB");
  EXPECT_EQ(bytesText(999999), "1 MB");
  EXPECT_EQ(bytesText(1213445120), "1.21 GB");
}

/** Adds a search with one bin size and the given energies. */
void
addSearch(Json& steps,
          const std::string& name,
          double size,
          std::vector<double> energies)
{
  for (const double energy : energies) {
    steps["search"].push_back(name);
    steps["bin_size"].push_back(size);
    steps["energy"].push_back(energy);
  }
}

TEST(PageEnergy, BreaksTheLineWhereEnergiesAreNotComparable)
{
  Json steps;
  addSearch(steps, "wide", 0.4, {1000, 900, 800});
  addSearch(steps, "wide", 0.1, {5, 4});
  addSearch(steps, "<fine>", 0.1, {7, 6.5});
  const std::string figure = energyFigure(steps);
  EXPECT_EQ(htmlFault(figure), "");
  EXPECT_EQ(countOf(figure, "<path "), 3U);
  EXPECT_EQ(countOf(figure, "<path stroke=\"#195abe\""), 2U);
  EXPECT_EQ(countOf(figure, "<path stroke=\"#c81e28\""), 1U);
  EXPECT_THAT(figure, HasSubstr("&lt;fine&gt;"));
}

/** Minimum and maximum y coordinate at which a line begins; 0 is the upper edge of the
 * picture. */
std::pair<double, double>
rowsOf(const std::string& figure)
{
  double least = std::numeric_limits<double>::max(), most = -least;
  std::smatch found;
  const std::regex dot("cy=\"([^\"]*)\"");
  for (auto at = figure.cbegin(); std::regex_search(at, figure.cend(), found, dot);
       at = found.suffix().first) {
    least = std::min(least, std::stod(found[1]));
    most = std::max(most, std::stod(found[1]));
  }
  return {least, most};
}

TEST(PageEnergy, OnlyAFewOfManyLeaveThePicture)
{
  Json few, many;
  addSearch(few, "high", 0.1, {9, 1});
  addSearch(few, "low", 0.1, {5, 5});
  many = few;
  for (int i = 0; i < 100; ++i)
    addSearch(many, "low" + std::to_string(i), 0.1, {5, 4});
  EXPECT_GT(rowsOf(energyFigure(few)).first, 0);
  EXPECT_LT(rowsOf(energyFigure(many)).first, 0);
  EXPECT_LT(rowsOf(energyFigure(many)).second, 380);
}

TEST(PageEnergy, OfWildStepsCanBeDrawn)
{
  EXPECT_EQ(energyFigure({}), "");
  EXPECT_EQ(energyFigure({{"search", {"a"}}, {"energy", {1}}}), "");
  EXPECT_EQ(energyFigure({{"search", "a"}, {"bin_size", 1}, {"energy", {1}}}), "");
  Json steps;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  addSearch(steps, "a", 0.1, {5, 4, 1e300, 3, std::nan(""), -infinity, 2, 1e90, 1});
  steps["energy"].push_back(nullptr);
  steps["search"].push_back(7);
  steps["bin_size"].push_back("no number");
  const std::string figure = energyFigure(steps);
  EXPECT_EQ(htmlFault(figure), "");
  EXPECT_EQ(countOf(figure, "<path "), 3U);
  EXPECT_THAT(figure, Not(HasSubstr("nan")));
  EXPECT_THAT(figure, Not(HasSubstr("inf")));
  Json one;
  addSearch(one, "a", 0.1, {5});
  EXPECT_EQ(countOf(energyFigure(one), "<circle "), 1U);
  Json none;
  addSearch(none, "a", 0.1, {infinity, infinity});
  EXPECT_EQ(countOf(energyFigure(none), "<path "), 0U);
}

TEST(PageSeconds, ReusedStagesAreMarkedAndNotCounted)
{
  const Json report = {
      {"stages",
       {{{"name", "stereo"}, {"reused", true}, {"seconds", {{"match", 30.0}}}},
        {{"name", "map"},
         {"reused", false},
         {"seconds", {{"mesh", 4.0}, {"write", 6}}}},
        {{"name", "without"}}}},
      {"seconds", {{"map", 10.0}, {"write", 6.0}, {"report", 0.5}, {"odd", "text"}}}};
  const RunSeconds seconds = secondsOfRun(report);
  ASSERT_EQ(seconds.stages.size(), 3U);
  EXPECT_TRUE(seconds.stages[0].is_reused);
  EXPECT_EQ(seconds.stages[1].total(), 10);
  EXPECT_EQ(seconds.stages[2].steps.size(), 1U); // the others belong to stages
  EXPECT_EQ(seconds.total(), 10.5);
  const std::string table = secondsTable(report);
  EXPECT_EQ(htmlFault(table), "");
  EXPECT_EQ(countOf(table, "<em>reused</em>"), 1U);
  EXPECT_THAT(table, HasSubstr("width:100.0%"));
  EXPECT_THAT(table, HasSubstr("width:33.3%"));
  EXPECT_EQ(secondsTable(Json::object()), "");
}

TEST(PageTables, PlanesHaveEquationsAndUnits)
{
  const Json planes = {{{"id", 4},
                        {"coefficients", {-0.99999, 0, -0.0024, 1.21}},
                        {"support", 6522137},
                        {"rmse", 0.00351},
                        {"area", 62.8307}},
                       {{"coefficients", {1, 2}}, {"area", nullptr}},
                       {{"coefficients", {1, 0, std::nan(""), 2}}, {"rmse", "much"}}};
  const Json report = {{"stages", {{{"details", {{"planes", planes}}}}}}};
  const std::string table = planesTable(report);
  EXPECT_EQ(htmlFault(table), "");
  const std::string space = "\xC2\xA0", sign = minus + space;
  EXPECT_THAT(table,
              HasSubstr(minus + ("1.0000" + space) + "x +" + space + "0.0000" + space +
                        "y " + sign + "0.0024" + space + "z +" + space + "1.2100" +
                        space + "=" + space + "0<"));
  EXPECT_THAT(table, HasSubstr(">62.83<"));
  EXPECT_THAT(table, HasSubstr(">3.51<"));
  EXPECT_THAT(table, HasSubstr(">6,522,137<"));
  EXPECT_EQ(countOf(table, "\xE2\x80\x93"),
            8U); // missing values of two planes
  EXPECT_EQ(planesTable({{"stages", {{{"details", {{"planes", 3}}}}}}}), "");
}

TEST(PageResult, TellsEachWarningOnce)
{
  const Json report = {{"stages",
                        {{{"name", "stereo"}, {"warnings", {"too dark", "a < b"}}},
                         {{"name", "map"}, {"warnings", {"too dark", 5}}}}},
                       {"remarks", {"a < b", "of the run"}}};
  const std::string box = warningBox(report);
  EXPECT_EQ(htmlFault(box), "");
  EXPECT_THAT(box, HasSubstr("3 warnings"));
  EXPECT_EQ(countOf(box, "too dark"), 1U);
  EXPECT_EQ(countOf(box, "a &lt; b"), 1U);
  EXPECT_THAT(warningBox(Json::object()), HasSubstr("No warnings"));
}

TEST(PageResult, CountsWhatTheLastStageCounted)
{
  const Json report = {
      {"stages",
       {{{"details", {{"observations", {"a", "b", "c"}}}}},
        {{"details",
          {{"planes", 1},
           {"finite_points", 2000},
           {"points_on_planes", 1500},
           {"bytes", {{"raw", 32000}, {"map.glb", 100}, {"geometry", 0}}}}}}}}};
  const std::string text = resultParagraph(report);
  EXPECT_EQ(htmlFault(text), "");
  EXPECT_THAT(text,
              HasSubstr("1 plane</strong> from 3 observations with 2,000 points"));
  EXPECT_THAT(text, HasSubstr("75 % of them on a plane"));
  EXPECT_THAT(text, HasSubstr("320 : 1"));
  EXPECT_EQ(resultParagraph(Json::object()), "");
}

} // namespace
} // namespace pcl::acmap::test
