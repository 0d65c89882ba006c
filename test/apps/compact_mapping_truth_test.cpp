#include "compact_map_runs.h"
#include "plane_runs.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/** The comparison with the truth in the report of a run; its poses are the true ones,
 * and are not rectified. */
nlohmann::json
truthOf(const ToolRun& run, const std::string& map)
{
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("true planes:"));
  EXPECT_THAT(run.out, HasSubstr("ATE:"));
  return jsonOfFile(map + "/report.json").at("truth");
}

TEST(CompactMappingTruth, TellsFiveFigures)
{
  const TemporaryFolder folder;
  const std::string map = folder.path("map");
  const ToolRun run = runMapping({corridor().session,
                                  "-o",
                                  map,
                                  "--no-pictures",
                                  "--no-rectification",
                                  "--truth",
                                  corridor().session});
  const auto truth = truthOf(run, map);
  EXPECT_GE(truth.at("main_planes"), 5);
  EXPECT_GE(truth.at("main_planes_found"), 4);
  EXPECT_LT(truth.at("mean_angle_deg"), 0.3);
  EXPECT_LT(truth.at("mean_offset_m"), 0.01);
  EXPECT_NEAR(truth.at("ate_before_m"), 0, 1e-9);
  EXPECT_NEAR(truth.at("ate_after_m"), 0, 1e-9);
  const nlohmann::json bytes = jsonOfFile(map + "/report.json").at("bytes");
  EXPECT_NEAR(truth.at("compactness"),
              bytes.at("raw").get<double>() / bytes.at("textured").get<double>(),
              1e-6);
}

TEST(CompactMappingTruth, ObservationsMayBeLost)
{
  const TemporaryFolder folder;
  const std::string session = copyOfSession(folder.path("session"));
  fs::remove(observation(session, 0));
  std::ofstream(observation(session, 2)) << "no cloud";
  const std::string map = folder.path("map");
  const ToolRun run = runMapping({session,
                                  "-o",
                                  map,
                                  "--no-pictures",
                                  "--no-rectification",
                                  "--skip-broken",
                                  "--truth",
                                  corridor().session});
  const auto truth = truthOf(run, map);
  EXPECT_GE(truth.at("main_planes_found"), 1);
  EXPECT_NEAR(truth.at("ate_after_m"), 0, 1e-9);
  EXPECT_NEAR(truth.at("from_first").at("ate_after_m"), 0, 1e-9);
}

TEST(CompactMappingTruth, IsReadBeforeAnythingIsDone)
{
  const TemporaryFolder folder;
  const std::string map = folder.path("map");
  const ToolRun none =
      runMapping({corridor().session, "-o", map, "--truth", folder.path("none")});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_THAT(none.err, HasSubstr("truth.json"));
  folder.write("truth.json", "{\"planes\": 3}");
  const ToolRun garbled =
      runMapping({corridor().session, "-o", map, "--truth", folder.path(".")});
  EXPECT_EQ(garbled.exit_code, 3);
  EXPECT_THAT(garbled.err, HasSubstr("truth.json: "));
  EXPECT_FALSE(fs::exists(map));
  const ToolRun cloud =
      runMapping({corridor().merged, "-o", map, "--truth", corridor().session});
  EXPECT_EQ(cloud.exit_code, 2);
}

} // namespace
} // namespace pcl::acmap::test
