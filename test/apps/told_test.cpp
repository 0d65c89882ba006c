#include "told.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using Json = nlohmann::ordered_json;

Told
sample()
{
  Told told;
  told.lines = {{"planes", "3"}, {"planes", "again"}};
  told.details = {{"a", {1, 2.5, nullptr}}};
  told.report.seconds = {{"read", 0.25}, {"match", 1.5}};
  told.report.remarks = {"odd \"name\"", ""};
  return told;
}

TEST(Told, ComesBackFromAReport)
{
  const Told there = sample();
  const Told back = toldIn(Json::parse(jsonOf(there).dump()));
  EXPECT_EQ(back.lines, there.lines);
  EXPECT_EQ(back.details, there.details);
  EXPECT_EQ(back.report.seconds, there.report.seconds);
  EXPECT_EQ(back.report.remarks, there.report.remarks);
}

TEST(Told, SumsTheSeconds)
{
  EXPECT_EQ(totalSeconds(sample()), 1.75);
  EXPECT_EQ(totalSeconds(Told()), 0);
}

TEST(Told, OtherThingsAreRefused)
{
  for (const char* name : {"seconds", "summary", "warnings", "details"}) {
    Json json = jsonOf(sample());
    json.erase(name);
    EXPECT_THROW(toldIn(json), nlohmann::json::exception) << name;
  }
  for (const auto& [name, value] :
       {std::pair<const char*, Json>{"seconds", {{"a", "b"}}},
        {"summary", {1, 2}},
        {"warnings", {1}},
        {"details", "none"}}) {
    Json json = jsonOf(sample());
    json[name] = value;
    EXPECT_THROW(toldIn(json), nlohmann::json::exception) << name;
  }
  EXPECT_THROW(toldIn(Json()), nlohmann::json::exception);
  EXPECT_THROW(toldIn(Json::array()), nlohmann::json::exception);
}

} // namespace
} // namespace pcl::acmap::test
