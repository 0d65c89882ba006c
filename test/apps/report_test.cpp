#include "json_file.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pcl::acmap::test {
namespace {

TEST(ReportFile, HoldsWhatTheRunDid)
{
  const TemporaryFolder folder;
  const std::string input = folder.write("in.pcd", planePcd());
  const std::string output = folder.path("out.ply");
  const std::string path = folder.path("r.json");
  runSurface({input, output, "--report", path, "--quiet"}).succeeded();
  const auto json = jsonOfFile(path);
  EXPECT_EQ(json["tool"], "pcl_dewall_surface");
  EXPECT_EQ(json["version"], ACMAP_VERSION);
  EXPECT_EQ(json["command_line"].size(), 6u);
  EXPECT_EQ(json["input"], input);
  EXPECT_EQ(json["output"], output);
  EXPECT_EQ(json["report"]["points"], 400);
  EXPECT_GT(json["report"]["triangles"], 600);
  EXPECT_GT(json["report"]["boundary_edges"], 0);
  EXPECT_NEAR(json["report"]["median_spacing"], 0.01, 0.005);
  for (const char* step : {"read", "triangulate", "write"})
    EXPECT_GE(json["seconds"][step], 0.0) << step;
  EXPECT_GT(json["peak_memory_bytes"], 1000000);
  EXPECT_TRUE(json["remarks"].is_array());
}

TEST(ReportFile, TellsTheWarnings)
{
  const TemporaryFolder folder;
  const std::string input = folder.write("in.pcd", planePcd());
  const std::string path = folder.path("r.json");
  ASSERT_EQ(runSurface({input, folder.path("a.ply"), "-scale", "1000", "-report", path})
                .exit_code,
            0);
  const auto json = jsonOfFile(path);
  ASSERT_EQ(json["remarks"].size(), 1u);
  EXPECT_NE(json["remarks"][0].get<std::string>().find("millimetres"),
            std::string::npos);
}

} // namespace
} // namespace pcl::acmap::test
