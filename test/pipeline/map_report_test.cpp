#include "house_map.h"
#include "html_checker.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/image_file.h>
#include <pcl/core/impl/base64.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/pipeline/map_report.h>

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <regex>
#include <string_view>
#include <vector>

namespace pcl::acmap::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

constexpr const char* minus = "\xE2\x88\x92";
const std::string space = "\xC2\xA0"; // where no line may break

/** A report with all possible entries, and a name full of special characters. */
Json
fullReport(const std::string& name)
{
  const Json stage = {
      {"name", name},
      {"reused", false},
      {"seconds", {{name, 1.5}, {"write", 0.1}}},
      {"summary", Json::array({Json::array({name, "<i>" + name})})},
      {"warnings", {"http://" + name}},
      {"details",
       {{"steps",
         {{"search", {name, name}}, {"bin_size", {0.1, 0.1}}, {"energy", {3.0, 2.0}}}},
        {"planes",
         {{{"id", 0},
           {"coefficients", {0, -1, 0, 1.25}},
           {"area", 58.8},
           {"rmse", 0.005},
           {"description", "Wall of " + name},
           {"support", 100}}}},
        {"rooms", {{{"description", "Room 1, 24.8 m²"}}}},
        {"plan",
         {{"axes", {{1, 0, 0}, {0, 0, 1}}},
          {"rooms", Json::array({{{0, 0}, {4, 0}, {4, 3}, {0, 3}}})},
          {"furniture", Json::array({{{1, 1}, {2, 1}, {2, 2}}})},
          {"walls", Json::array({{0, 0, 4, 0, 0}})},
          {"patch_size", 0.2},
          {"unseen",
           Json::array({{3, 1, "floor"}, {4, 1, "wall"}, {1, 2, "ceiling"}})}}},
        {"bytes", {{"raw", 1600}, {"textured", 8}, {"geometry", 4}}}}}};
  return {
      {"tool", "pcl_compact_mapping"},
      {"version", "0.1.0"},
      {"command_line", {"pcl_compact_mapping", name, "-o", "map"}},
      {"input", name},
      {"starting_point", "cloud"},
      {"stages", {stage}},
      {"truth",
       {{"main_planes_found", 7},
        {"main_planes", 7},
        {"ate_before_m", 0.036},
        {"ate_after_m", 0.014},
        {"compactness", 240.9}}},
      {"quality",
       {{"outcome", "Not usable"},
        {"sentence", "surfaces are 31 mm thick."},
        {"sharpness",
         {{"value", 0.031},
          {"good", 0.002},
          {"bad", 0.02},
          {"advice", "Move slower."}}},
        {"overlap", {{"value", nullptr}, {"good", 0.2}, {"bad", 0.05}, {"advice", ""}}},
        {"roughness", {0.031}}}},
      {"next_positions",
       {{"positions",
         {{{"eye", {1, 0, 1}},
           {"direction", {1, 0, 0}},
           {"uncovered", 12.345},
           {"words", "Behind the table; look up"}}}}}},
      {"pictures", {{{"file", "inside.png"}, {"caption", name}}, {{"file", name}}}},
      {"seconds", {{"pictures", 1.0}}},
      {"peak_memory_bytes", 1000000},
      {"remarks", {name}}};
}

constexpr const char* worst_name = "<script src=\"http://a.b/c.js\">&'\xFF\x01.pcd";

MapReport
reportOf(const Json& report)
{
  return MapReport(report.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string
reportPage(const Json& report, const std::string& folder)
{
  return reportOf(report).page(folder);
}

/** With its only pictures. */
std::string
pageOf(const Json& report)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("pictures"));
  for (const char* name : {"inside.png", "pictures/energy.png"})
    savePng(folder.path(name), {2, 2, std::vector<std::uint8_t>(12, 90)});
  return reportPage(report, folder.path(""));
}

std::size_t
countOf(const std::string& text, const std::string& part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + part.size()))
    ++count;
  return count;
}

TEST(Ratio, TellsWhatIsLarger)
{
  EXPECT_EQ(ratioText(240.9), "240 : 1");
  EXPECT_EQ(ratioText(1), "1 : 1");
  EXPECT_EQ(ratioText(0.4), "1 : 3");
  EXPECT_EQ(ratioText(0), "0 : 1");
}

TEST(ReportPage, ShowsAllThatIsTold)
{
  const std::string page = pageOf(fullReport("corridor"));
  EXPECT_EQ(htmlFault(page), "");
  for (const char* text : {"<title>Compact map of corridor</title>",
                           "pcl_compact_mapping corridor -o map",
                           "<strong>200 : 1</strong>",
                           "2 warnings",
                           "7 of 7",
                           "<td>240 : 1</td>",
                           "0.389",
                           "<img ",
                           "corridor is missing or damaged",
                           "<summary>Energy of the rectification</summary>",
                           ">58.80<",
                           "<li value=\"0\">Wall of corridor</li>",
                           "<li>Room 1, 24.8 m²</li>",
                           "2.60 s",
                           "&lt;i&gt;corridor",
                           "1 MB"})
    EXPECT_THAT(page, HasSubstr(text));
  EXPECT_EQ(countOf(page, "<img "), 1U);
}

/** Its first heading is the verdict, and nothing else is. */
TEST(ReportPage, BeginsWithAVerdict)
{
  const std::string page = pageOf(fullReport("corridor"));
  const std::size_t heading = page.find("<h1");
  EXPECT_EQ(page.substr(heading, page.find("</h1>") - heading),
            "<h1 class=\"outcome\">Not usable");
  for (const char* text : {"Surfaces are 31 mm thick.",
                           "Sharpness: 31.0 mm",
                           "Overlap: not known",
                           "Move slower.",
                           "Behind the table; look up.",
                           "It shows 12.3 m² more.",
                           "<strong>31 mm</strong> Wall of corridor"})
    EXPECT_THAT(page, HasSubstr(text));
  EXPECT_EQ(countOf(page, "<svg class=\"scale\""), 2U);
  EXPECT_EQ(countOf(page, "<svg class=\"places\""), 1U);
  EXPECT_LT(heading, page.find("<h2"));
  Json report = fullReport("corridor");
  for (const Json& other : {Json("Excellent"), Json(3), Json()}) {
    report["quality"]["outcome"] = other;
    EXPECT_THAT(pageOf(report), Not(HasSubstr("class=\"outcome\">")));
  }
}

TEST(ReportPage, LinksOnlyWhatIsThere)
{
  const TemporaryFolder folder;
  EXPECT_THAT(reportPage(fullReport("corridor"), folder.path("")),
              Not(HasSubstr("href")));
  std::ofstream(folder.path("map.html")) << "a map";
  const std::string page = reportPage(fullReport("corridor"), folder.path(""));
  EXPECT_THAT(page, HasSubstr("<a href=\"map.html\">"));
  EXPECT_EQ(countOf(page, "href"), 1U);
  EXPECT_EQ(htmlFault(page), "");
}

TEST(ReportPage, QualityAndPlanMayBeAnything)
{
  const Json full = fullReport("corridor");
  const auto check = [](const Json& report) {
    EXPECT_EQ(htmlFault(pageOf(report)), "");
  };
  for (const Json& instead : {Json(),
                              Json(7),
                              Json("<b>"),
                              Json::array({1, Json(), "a"}),
                              Json::array({Json::array({1e300, 2, 3, 4, 5})}),
                              Json::object({{"value", std::nan("")}})}) {
    for (const auto& field : full["quality"].items()) {
      Json report = full;
      report["quality"][field.key()] = instead;
      check(report);
    }
    for (const auto& field : full["stages"][0]["details"]["plan"].items()) {
      Json report = full;
      report["stages"][0]["details"]["plan"][field.key()] = instead;
      check(report);
    }
  }
}

TEST(ReportPage, FillsAllPlacesOfItsTemplate)
{
  EXPECT_THAT(pageOf(fullReport("corridor")), Not(HasSubstr("{{")));
  EXPECT_THAT(pageOf(Json()), Not(HasSubstr("{{")));
  // what stands in a value is no place
  EXPECT_THAT(pageOf(fullReport("{{tool}}")), HasSubstr("Compact map of {{tool}}<"));
}

TEST(ReportPage, IsSoundWithTheWorstOfNames)
{
  const std::string page = pageOf(fullReport(worst_name));
  EXPECT_EQ(htmlFault(page), "");
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page,
              HasSubstr("&lt;script src=&quot;http://a.b/c.js&quot;&gt;&amp;&#39;"));
}

TEST(ReportPage, NeedsNoOtherFileAndNoNetwork)
{
  const std::string page = pageOf(fullReport(worst_name));
  const std::regex attribute("[ \n](src|href|srcset|action|data)=\"([^\"]*)\"");
  int sources = 0;
  for (std::sregex_iterator found(page.begin(), page.end(), attribute), end;
       found != end;
       ++found, ++sources)
    EXPECT_EQ((*found)[2].str().rfind("data:image/png;base64,", 0), 0U) << found->str();
  EXPECT_EQ(sources, 1);
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(ReportPage, LeavesOutWhatIsNotTold)
{
  const Json full = fullReport("corridor");
  for (const auto& field : full.items())
    for (const Json& instead : {Json(),
                                Json(7),
                                Json("text"),
                                Json::array({1, Json()}),
                                Json::object({{"a", "b"}})}) {
      Json report = full;
      report[field.key()] = instead;
      EXPECT_EQ(htmlFault(pageOf(report)), "") << field.key() << " " << instead;
      report = full;
      report.erase(field.key());
      EXPECT_EQ(htmlFault(pageOf(report)), "") << field.key();
    }
  for (const Json& nothing : {Json(), Json::object(), Json::array(), Json("text")}) {
    const std::string page = pageOf(nothing);
    EXPECT_EQ(htmlFault(page), "");
    for (const char* part : {"<h2>", "<table", "<img ", "<figure", "<pre"})
      EXPECT_THAT(page, Not(HasSubstr(part)));
  }
}

TEST(ReportPage, FieldsOfAStageMayBeAnything)
{
  const Json full = fullReport("corridor");
  for (const auto& field : full["stages"][0].items())
    for (const Json& instead : {Json(),
                                Json(7),
                                Json("text"),
                                Json::array({1, Json()}),
                                Json::object({{"a", "b"}})}) {
      Json report = full;
      report["stages"][0][field.key()] = instead;
      EXPECT_EQ(htmlFault(pageOf(report)), "") << field.key() << " " << instead;
    }
}

TEST(ReportPage, IsWrittenWholeWithTheSameBytes)
{
  const TemporaryFolder folder;
  savePng(folder.path("inside.png"), {2, 2, std::vector<std::uint8_t>(12, 90)});
  const Json report = fullReport(worst_name);
  reportOf(report).savePage(folder.path("a.html"), folder.path(""));
  reportOf(report).savePage(folder.path("b.html"), folder.path(""));
  const std::string page = contentOf(folder.path("a.html"));
  EXPECT_EQ(page, contentOf(folder.path("b.html")));
  EXPECT_EQ(page, reportPage(report, folder.path("")));
  EXPECT_EQ(folder.count(), 3);
  EXPECT_THROW(reportOf(report).savePage(folder.path("no/such/folder.html"), ""),
               OutputFileException);
}

/** How the page shows the name of an input. */
std::string
escaped(const std::string& text)
{
  const std::string page = pageOf({{"input", text}});
  std::smatch found;
  std::regex_search(page, found, std::regex("<title>Compact map of ([^]*)</title>"));
  EXPECT_EQ(htmlFault(page), "");
  return found[1];
}

TEST(ReportPage, EscapesTexts)
{
  EXPECT_EQ(escaped("<b>&\"'.pcd"), "&lt;b&gt;&amp;&quot;&#39;.pcd");
  EXPECT_EQ(escaped("K\xC3\xBC"
                    "che \xE2\x82\xAC \xF0\x9F\x8F\xA0"),
            "K\xC3\xBC"
            "che \xE2\x82\xAC \xF0\x9F\x8F\xA0");
  EXPECT_THAT(pageOf({{"input", ""}}), HasSubstr("<title>Compact map</title>"));
}

TEST(ReportPage, ReplacesWhatIsNoText)
{
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(escaped("a\xFF"
                    "b"),
            "a" + replaced + "b");
  EXPECT_EQ(escaped("\xC3"), replaced);                // truncated
  EXPECT_EQ(escaped("\xC3<"), replaced + "&lt;");      // the next character is kept
  EXPECT_EQ(escaped("\xC0\xBC"), replaced + replaced); // an overlong form of <
  // half of a surrogate pair
  EXPECT_EQ(escaped("\xED\xA0\x80"), replaced + replaced + replaced);
  EXPECT_EQ(escaped("\xF5\x80\x80\x80").substr(0, 3), replaced); // above U+10FFFF
  EXPECT_EQ(escaped(std::string("\0\x1B\r\x7F", 4)),
            replaced + replaced + replaced + replaced);
}

TEST(ReportPage, CommandLineCanBeGivenToAShell)
{
  EXPECT_THAT(pageOf({{"command_line", {"tool", "a/b-c.pcd", "--texel=0.02"}}}),
              HasSubstr("<code>tool a/b-c.pcd --texel=0.02</code>"));
  EXPECT_THAT(pageOf({{"command_line", {"tool", "", "it's $HOME", "~"}}}),
              HasSubstr("<code>tool &#39;&#39; &#39;it&#39;\\&#39;&#39;s $HOME&#39; "
                        "&#39;~&#39;</code>"));
}

TEST(ReportPage, NumbersHaveSensibleDigits)
{
  const auto expect = [](double number, const std::string& text) {
    EXPECT_THAT(pageOf({{"truth", {{"main_planes_found", number}}}}),
                HasSubstr("<td>" + text + "</td>"));
  };
  expect(0, "0");
  expect(138653, "138,653");
  expect(14697233, "14,697,233");
  expect(999.4, "999");
  expect(999.6, "1,000");
  expect(0.0213456, "0.0213");
  expect(-1234.5, minus + std::string("1,234"));
  expect(1e300, "1e+300");
}

TEST(ReportPage, SecondsAndBytesHaveUnits)
{
  for (const auto& [seconds, text] : {std::pair{0.25, "0.25 s"},
                                      {12.34, "12.3 s"},
                                      {119.96, "2 min 00 s"},
                                      {185, "3 min 05 s"}})
    EXPECT_THAT(pageOf({{"seconds", {{"write", seconds}}}}),
                HasSubstr("Took " + std::string(text) + "."));
  for (const auto& [bytes, text] : {std::pair{0.0, "0 bytes"},
                                    {221316, "221 kB"},
                                    {999999, "1 MB"},
                                    {1213445120, "1.21 GB"}})
    EXPECT_THAT(pageOf({{"peak_memory_bytes", bytes}}),
                HasSubstr("at most " + std::string(text) + " of memory."));
}

Json
reportOfDetails(const Json& details)
{
  return {{"stages", {{{"details", details}}}}};
}

TEST(ReportPage, ShowsTheEnergyIfThereAreSteps)
{
  const Json steps = {{"search", {"a", "a", "b"}},
                      {"bin_size", {0.1, 0.1, 0.1}},
                      {"energy", {3.0, 1.0, 7.0}}};
  const std::string page = pageOf(reportOfDetails({{"steps", steps}}));
  EXPECT_EQ(htmlFault(page), "");
  EXPECT_EQ(countOf(page, "<svg class=\"energy\""), 1U);
  EXPECT_THAT(page, HasSubstr("Energy of the rectification"));
  EXPECT_THAT(page, HasSubstr("3 steps"));
  // the highest one is 2 above the lowest of its kind, and the other kind has a line of its own
  EXPECT_THAT(page, HasSubstr(">2</text>"));
  const std::size_t line = page.find("<path d=\"M64 12h.1L");
  ASSERT_NE(line, std::string::npos);
  EXPECT_EQ(countOf(page.substr(line, page.find('/', line) - line), "M"), 2U);
  for (const Json& none : {Json(), Json::object(), Json({{"energy", "a"}}), Json(7)})
    EXPECT_THAT(pageOf(reportOfDetails({{"steps", none}})),
                Not(HasSubstr("Energy of the rectification")));
}

TEST(ReportPage, MarksReusedStagesAndDoesNotCountTheirSeconds)
{
  const Json report = {
      {"stages",
       {{{"name", "stereo"}, {"reused", true}, {"seconds", {{"match", 30.0}}}},
        {{"name", "map"},
         {"reused", false},
         {"seconds", {{"mesh", 4.0}, {"write", 6}}}},
        {{"name", "without"}}}},
      {"seconds", {{"map", 10.0}, {"write", 6.0}, {"report", 0.5}, {"odd", "text"}}}};
  const std::string page = pageOf(report);
  EXPECT_EQ(htmlFault(page), "");
  EXPECT_EQ(countOf(page, "<tr class=\"stage\">"), 3U); // with the rest of the run
  EXPECT_EQ(countOf(page, "<tr class=\"step\">"), 4U);
  EXPECT_EQ(countOf(page, "<em>reused</em>"), 1U);
  const auto row = [](const std::string& name, const std::string& time) {
    return "<th scope=\"row\">" + name + "</th><td class=\"number\">" + time;
  };
  for (const std::string& part : {row("stereo", "30.0 s<br><em>reused</em></td>"),
                                  row("map", "10.0 s</td>"),
                                  row("mesh", "4.00 s</td>"),
                                  row("rest of the run", "0.50 s</td>"),
                                  row("report", "0.50 s</td>"),
                                  row("this run", "10.5 s</td>"),
                                  std::string("Took 10.5 s, with 1 stage reused")})
    EXPECT_THAT(page, HasSubstr(part));
  EXPECT_THAT(pageOf(Json::object()), Not(HasSubstr("<summary>Time")));
}

TEST(ReportPage, PlanesHaveEquationsAndUnits)
{
  const Json planes = {{{"id", 4},
                        {"coefficients", {-0.99999, 0, -0.0024, 1.21}},
                        {"support", 6522137},
                        {"rmse", 0.00351},
                        {"area", 62.8307}},
                       {{"coefficients", {1, 2}}, {"area", nullptr}},
                       {{"coefficients", {1, 0, std::nan(""), 2}}, {"rmse", "much"}}};
  const std::string page = pageOf(reportOfDetails({{"planes", planes}}));
  EXPECT_EQ(htmlFault(page), "");
  const std::string sign = minus + space;
  EXPECT_THAT(page,
              HasSubstr(">" + (minus + ("1.0000" + space)) + "x +" + space + "0.0000" +
                        space + "y " + sign + "0.0024" + space + "z +" + space +
                        "1.2100" + space + "=" + space + "0<"));
  EXPECT_THAT(page, HasSubstr(">4<"));
  EXPECT_THAT(page, HasSubstr(">62.83<"));
  EXPECT_THAT(page, HasSubstr(">3.51<"));
  EXPECT_THAT(page, HasSubstr(">6,522,137<"));
  EXPECT_EQ(countOf(page, "\xE2\x80\x93"), 8U); // missing values of two planes
  EXPECT_THAT(pageOf(reportOfDetails({{"planes", 3}})), Not(HasSubstr("<table")));
}

TEST(ReportPage, BitsOfWhatIsFoundAreTold)
{
  const std::string page = pageOf(reportOfDetails(
      {{"cylinder_report",
        {{"cylinders", 9}, {"bits_before", 563200.4}, {"bits_after", 524100.0}}},
       {"box_report", {{"boxes", 0}, {"bits_before", 0}, {"bits_after", 0}}},
       {"recess_report", {{"recesses", 2}, {"bits_before", 187.4}}}}));
  EXPECT_EQ(htmlFault(page), "");
  EXPECT_THAT(page, HasSubstr(">cylinders<"));
  EXPECT_THAT(page, HasSubstr(">563,200<"));
  EXPECT_THAT(page, HasSubstr(">524,100<"));
  EXPECT_THAT(page, Not(HasSubstr(">boxes<"))) << "there is none";
  EXPECT_THAT(page, HasSubstr(">recesses<"));
  EXPECT_EQ(countOf(page, "\xE2\x80\x93"), 1U); // the missing value
  EXPECT_THAT(pageOf(reportOfDetails({{"cylinder_report", {{"cylinders", 0}}}})),
              Not(HasSubstr("<table")));
}

TEST(ReportPage, NumbersInTablesHaveFixedDigits)
{
  const Json planes = {{{"coefficients", {-0.00004, 1, 0, 0}}, {"area", -1234567.25}},
                       {{"area", std::numeric_limits<double>::max()}}};
  const std::string page = pageOf(reportOfDetails({{"planes", planes}}));
  EXPECT_EQ(htmlFault(page), "");
  EXPECT_THAT(page, HasSubstr(">0.0000" + space + "x"));
  EXPECT_THAT(page, HasSubstr(minus + std::string("1,234,567.25<")));
  EXPECT_TRUE(std::regex_search(page, std::regex(">[0-9,]{309,}\\.00<")));
}

TEST(ReportPage, TellsEachWarningOnce)
{
  const Json report = {{"stages",
                        {{{"name", "stereo"}, {"warnings", {"too dark", "a < b"}}},
                         {{"name", "map"}, {"warnings", {"too dark", 5}}}}},
                       {"remarks", {"a < b", "of the run"}}};
  const std::string page = pageOf(report);
  EXPECT_EQ(htmlFault(page), "");
  EXPECT_THAT(page, HasSubstr("3 warnings"));
  EXPECT_EQ(countOf(page, "too dark"), 1U);
  EXPECT_EQ(countOf(page, "a &lt; b"), 1U);
  EXPECT_THAT(pageOf(Json::object()), HasSubstr("No warnings"));
}

TEST(ReportPage, CountsWhatTheLastStageCounted)
{
  const Json report = {
      {"stages",
       {{{"details", {{"observations", {"a", "b", "c"}}}}},
        {{"details",
          {{"planes", 1},
           {"finite_points", 2000},
           {"points_on_planes", 1500},
           {"bytes", {{"raw", 32000}, {"textured", 100}, {"geometry", 0}}}}}}}}};
  const std::string page = pageOf(report);
  EXPECT_EQ(htmlFault(page), "");
  EXPECT_THAT(page,
              HasSubstr("1 plane</strong> from 3 observations with 2,000 points"));
  EXPECT_THAT(page, HasSubstr("75 % of them on a plane"));
  EXPECT_THAT(page, HasSubstr("320 : 1"));
  EXPECT_THAT(pageOf(Json::object()), HasSubstr("<p class=\"result\"></p>"));
}

TEST(Base64, IsThatOfTheStandard)
{
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string_view("\xFB\xEF\xFF\0", 4)), "++//AA==");
}

/** Page with one picture only. */
std::string
pageWith(const TemporaryFolder& folder,
         const std::string& name,
         const std::string& caption)
{
  return reportPage(
      {{"pictures", Json::array({{{"file", name}, {"caption", caption}}})}},
      folder.path(""));
}

TEST(ReportPage, HoldsThePictures)
{
  const TemporaryFolder folder;
  const RgbImage image = {4, 3, std::vector<std::uint8_t>(36, 200)};
  savePng(folder.path("a.png"), image);
  const std::string page = pageWith(folder, "a.png", "a \"b\"");
  EXPECT_EQ(htmlFault(page), "");
  EXPECT_THAT(page, HasSubstr("width=\"4\" height=\"3\" alt=\"a &quot;b&quot;\""));
  const std::vector<std::uint8_t> png = encodePng(image);
  EXPECT_THAT(
      page,
      HasSubstr("src=\"data:image/png;base64," +
                base64({reinterpret_cast<const char*>(png.data()), png.size()}) +
                "\""));
  EXPECT_THAT(page, HasSubstr("<figcaption>a &quot;b&quot;</figcaption>"));
  EXPECT_THAT(pageWith(folder, "a.png", ""),
              HasSubstr("<figcaption>a.png</figcaption>"));
}

TEST(ReportPage, SaysWhichPictureIsMissingOrDamaged)
{
  const TemporaryFolder folder;
  const RgbImage image = {40, 30, std::vector<std::uint8_t>(3600, 200)};
  savePng(folder.path("whole.png"), image);
  const std::string bytes = contentOf(folder.path("whole.png"));
  folder.write("cut.png", bytes.substr(0, bytes.size() / 2));
  folder.write("text.png", "no picture");
  // a picture, but not in a format for browsers
  folder.write("grey.png", "P5 1 1 255\n7");
  for (const std::string name : {"none.png", "cut.png", "text.png", "grey.png", "."}) {
    const std::string page = pageWith(folder, name, "It");
    EXPECT_EQ(htmlFault(page), "") << name;
    EXPECT_THAT(page, HasSubstr(name + " is missing or damaged")) << name;
    EXPECT_THAT(page, Not(HasSubstr("<img"))) << name;
  }
  EXPECT_THAT(pageWith(folder, "<n>", "It"),
              HasSubstr("“It”: &lt;n&gt; is missing or damaged"));
}

TEST(MapReport, IsMadeOfAMapAndTheReportOfItsChain)
{
  CompactMap map;
  addPlane(map, level({0, 0}, {4, 3}, 0, true));
  addPlane(map, upright({0, 0}, {4, 0}, 0, 2.5));
  map.planes[1].label.name = "Wall of a hall";
  map.shift = {1000, 0, 0};
  CompactMappingReport told;
  told.remarks = {"too dark"};
  told.merging.observations = 3;
  told.seconds = {{"texture", 2.5}};
  told.quality.emplace();
  told.quality->outcome = MapQualityOutcome::NotUsable;
  told.quality->sentence = "surfaces are 31 mm thick";
  told.rectification.emplace();
  told.rectification->steps.resize(2);

  const MapReport report(map, told);
  const Json json = Json::parse(report.text());
  EXPECT_EQ(json["planes"], 2);
  EXPECT_EQ(json["stages"].size(), 2U);
  EXPECT_EQ(json["stages"][0]["details"]["steps"]["energy"].size(), 2U);
  EXPECT_EQ(json["stages"][1]["details"]["shift"], Json({1000.0, 0.0, 0.0}));

  const std::string page = report.page("no folder");
  EXPECT_EQ(htmlFault(page), "");
  for (const char* text : {"<h1 class=\"outcome\">Not usable",
                           "Surfaces are 31 mm thick",
                           "2 planes</strong> from 3 observations",
                           "too dark",
                           "Took 2.50 s",
                           "Energy of the rectification",
                           "Wall of a hall"})
    EXPECT_THAT(page, HasSubstr(text));
  using testing::Pair;
  EXPECT_THAT(
      report.summary(),
      testing::ElementsAre(
          Pair("map", "Not usable: surfaces are 31 mm thick"),
          Pair("surfaces", "2 planes"),
          Pair("accuracy",
               "points within 6.8 mm of their planes (rms, half of the area)")));
}

TEST(MapReport, OfAnEmptyMapHasAPage)
{
  const MapReport report((CompactMap()), CompactMappingReport());
  EXPECT_EQ(htmlFault(report.page("")), "");
  EXPECT_TRUE(report.summary().empty());
}

TEST(MapReport, SummaryTakesAnyJson)
{
  const Json full = fullReport("corridor");
  EXPECT_EQ(reportOf(full).summary().front(),
            std::pair(std::string("map"),
                      std::string("Not usable: surfaces are 31 mm thick.")));
  for (const Json& instead :
       {Json(), Json(7), Json("text"), Json::array({1, Json()}), Json{{"a", "b"}}}) {
    EXPECT_TRUE(reportOf(instead).summary().empty());
    for (const auto& field : full.items()) {
      Json report = full;
      report[field.key()] = instead;
      EXPECT_NO_THROW(reportOf(report).summary()) << field.key() << instead;
    }
    Json report = full;
    report["stages"][0]["name"] = "map";
    for (const auto& field : full["stages"][0]["details"].items()) {
      report["stages"][0]["details"][field.key()] = instead;
      EXPECT_NO_THROW(reportOf(report).summary()) << field.key() << instead;
    }
  }
}

TEST(MapReport, IsReadFromItsFile)
{
  const TemporaryFolder folder;
  folder.write("report.json", R"({"planes": 7})");
  EXPECT_EQ(loadMapReport(folder.path("report.json")).summary().front().second,
            "7 planes");
  for (const char* text : {"", "{", "{} {}"}) {
    folder.write("report.json", text);
    EXPECT_THROW(loadMapReport(folder.path("report.json")), InputFileException) << text;
    EXPECT_THROW(MapReport{text}, BadArgumentException) << text;
  }
  EXPECT_THROW(MapReport(std::string(100000, '[') + std::string(100000, ']')),
               BadArgumentException);
  EXPECT_THROW(loadMapReport(folder.path("none.json")), InputFileException);
}

TEST(HtmlChecker, FindsFaults)
{
  EXPECT_EQ(htmlFault("<p>a &amp; b<br><img src=\"x\"></p>"), "");
  for (const char* page : {"<p>",
                           "</p>",
                           "<p><b></p></b>",
                           "a & b",
                           "a > b",
                           "<p class=x></p>",
                           "<p class=\"<\"></p>",
                           "<p",
                           "\xC3",
                           "<svg><g></svg></g>"})
    EXPECT_NE(htmlFault(page), "") << page;
}

} // namespace
} // namespace pcl::acmap::test
