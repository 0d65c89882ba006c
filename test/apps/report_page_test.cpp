#include "compact_mapping/report_page.h"
#include "html_checker.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/image_file.h>

#include <gmock/gmock.h>

#include <regex>

namespace pcl::acmap::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

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
           {"support", 100}}}},
        {"bytes", {{"raw", 1600}, {"map.glb", 8}, {"geometry", 4}}}}}};
  return {{"tool", "pcl_compact_mapping"},
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
          {"pictures", {{{"file", "inside.png"}, {"caption", name}}, {{"file", name}}}},
          {"seconds", {{"pictures", 1.0}}},
          {"peak_memory_bytes", 1000000},
          {"remarks", {name}}};
}

constexpr const char* worst_name = "<script src=\"http://a.b/c.js\">&'\xFF\x01.pcd";

/** With its only picture. */
std::string
pageOf(const Json& report)
{
  const TemporaryFolder folder;
  savePng(folder.path("inside.png"), {2, 2, std::vector<std::uint8_t>(12, 90)});
  return reportPage(report, folder.path(""));
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
                           "<svg ",
                           ">58.80<",
                           "2.60 s",
                           "&lt;i&gt;corridor",
                           "1 MB"})
    EXPECT_THAT(page, HasSubstr(text));
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
    for (const char* part : {"<h2>", "<table", "<svg ", "<figure", "<pre"})
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
  saveReportPage(folder.path("a.html"), report, folder.path(""));
  saveReportPage(folder.path("b.html"), report, folder.path(""));
  const std::string page = contentOf(folder.path("a.html"));
  EXPECT_EQ(page, contentOf(folder.path("b.html")));
  EXPECT_EQ(page, reportPage(report, folder.path("")));
  EXPECT_EQ(folder.count(), 3);
  EXPECT_THROW(saveReportPage(folder.path("no/such/folder.html"), report, ""),
               OutputFileException);
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
