#include "stage_log.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using Json = nlohmann::ordered_json;

StageLog
sample()
{
  StageLog told;
  told.lines = {{"planes", "3"}, {"planes", "again"}};
  told.details = {{"a", {1, 2.5, nullptr}}};
  told.report.seconds = {{"read", 0.25}, {"match", 1.5}};
  told.report.remarks = {"odd \"name\"", ""};
  return told;
}

TEST(StageLog, ComesBackFromAReport)
{
  const StageLog there = sample();
  const StageLog back = stageLogIn(Json::parse(jsonOf(there).dump()));
  EXPECT_EQ(back.lines, there.lines);
  EXPECT_EQ(back.details, there.details);
  EXPECT_EQ(back.report.seconds, there.report.seconds);
  EXPECT_EQ(back.report.remarks, there.report.remarks);
}

TEST(StageLog, SumsTheSeconds)
{
  EXPECT_EQ(totalSeconds(sample()), 1.75);
  EXPECT_EQ(totalSeconds(StageLog()), 0);
}

TEST(StageLog, OtherThingsAreRefused)
{
  for (const char* name : {"seconds", "summary", "warnings", "details"}) {
    Json json = jsonOf(sample());
    json.erase(name);
    EXPECT_THROW(stageLogIn(json), nlohmann::json::exception) << name;
  }
  for (const auto& [name, value] :
       {std::pair<const char*, Json>{"seconds", {{"a", "b"}}},
        {"summary", {1, 2}},
        {"warnings", {1}},
        {"details", "none"}}) {
    Json json = jsonOf(sample());
    json[name] = value;
    EXPECT_THROW(stageLogIn(json), nlohmann::json::exception) << name;
  }
  EXPECT_THROW(stageLogIn(Json()), nlohmann::json::exception);
  EXPECT_THROW(stageLogIn(Json::array()), nlohmann::json::exception);
}

} // namespace
} // namespace pcl::acmap::test
