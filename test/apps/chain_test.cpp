#include "chain_runs.h"
#include "plane_runs.h"
#include "virtual_display.h"

#include <pcl/core/trajectory.h>
#include <pcl/io/pcd_io.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <set>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(ChainTest, GoesFromShotsToAMap)
{
  for (const char* name : {"map.json",
                           "map.obj",
                           "map.mtl",
                           "map.glb",
                           "mesh.ply",
                           "map.pcd",
                           "trajectory.txt",
                           "trajectory_before.txt",
                           "pictures/plan.png",
                           "pictures/energy.png",
                           "report.json",
                           "report.html"})
    EXPECT_TRUE(fs::exists(map_ + "/" + name)) << name;
  std::size_t files = 0; // to be handed over, with the five pictures that need a screen
  for (const auto& [name, bytes] : resultsIn(map_))
    files += name.rfind("stages/", 0) == 0 ? 0 : 1;
  EXPECT_LE(files + 7, 24U) << "with report.json and report.html";
  EXPECT_THAT(hiddenIn(map_), IsEmpty());
  EXPECT_THAT(stagesOf(map_),
              ElementsAre("observations", "egomotion", "rectification", "map"));
  EXPECT_EQ(madeStages(map_), stagesOf(map_));
  const auto report = jsonOfFile(map_ + "/report.json");
  EXPECT_EQ(report.at("starting_point"), "raw session");
  EXPECT_EQ(report.at("observations"), 3);
  for (const auto& stage : report.at("stages")) {
    EXPECT_FALSE(stage.at("seconds").empty()) << stage.at("name");
    EXPECT_FALSE(stage.at("summary").empty()) << stage.at("name");
  }
  EXPECT_THAT(contentOf(map_ + "/report.html"), HasSubstr("</html>"));
}

TEST_F(ChainTest, TheCameraWentWhereItTrulyWent)
{
  const Trajectory truth = loadTrajectory(session_ + "/trajectory.txt");
  ASSERT_EQ(truth.poses.size(), 3u);
  for (const char* name : {"/trajectory.txt", "/trajectory_before.txt"}) {
    const Trajectory found = loadTrajectory(map_ + name);
    ASSERT_EQ(found.poses.size(), 3u) << name;
    const Eigen::Isometry3d way = found.poses.front().inverse() * found.poses.back();
    const Eigen::Isometry3d true_way =
        truth.poses.front().inverse() * truth.poses.back();
    EXPECT_LT((way.translation() - true_way.translation()).norm(), 0.03) << name;
    EXPECT_GT(true_way.translation().norm(), 0.7);
  }
}

TEST_F(ChainTest, ThePointsTellWhoSawThem)
{
  PCLPointCloud2 cloud;
  ASSERT_EQ(io::loadPCDFile(map_ + "/map.pcd", cloud), 0);
  std::vector<std::string> fields;
  for (const PCLPointField& field : cloud.fields)
    fields.push_back(field.name);
  EXPECT_THAT(fields, ElementsAre("x", "y", "z", "rgb", "view"));
  EXPECT_EQ(cloud.width * cloud.height,
            jsonOfFile(map_ + "/report.json").at("finite_points"));
}

TEST_F(ChainTest, TheMapOfAReplayIsThatOfTheStages)
{
  const std::string out = folder_.path("replayed");
  const ToolRun run =
      runSessionChain(session_, out, {"--as-recorded", "--threads", "2"}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("after the last shot"));
  for (const char* name : {"map.json",
                           "map.glb",
                           "map.obj",
                           "mesh.ply",
                           "floor_plan.svg",
                           "trajectory.txt",
                           "trajectory_before.txt"})
    EXPECT_EQ(contentOf(out + "/" + name), contentOf(map_ + "/" + name)) << name;
  EXPECT_THAT(stagesOf(out), ElementsAre("map"));
  const auto details =
      jsonOfFile(out + "/report.json").at("stages").at(0).at("details");
  EXPECT_GT(details.at("recorded_seconds"), 0);
  EXPECT_GT(details.at("seconds_after_last_shot"), 0);
  EXPECT_THAT(hiddenIn(out), IsEmpty());
  EXPECT_TRUE(fs::exists(out + "/stages/replay/observation_0002.pcd"));
}

TEST_F(ChainTest, TheMapOfAGrabberIsThatOfTheStages)
{
  const std::string out = folder_.path("grabbed");
  const auto grab = [&](const std::vector<std::string>& more) {
    return runTool(
        ACMAP_DIGICLOPS_GRABBER,
        joined({"--device", session_, "--map", out, "--min-depth", "1"}, more));
  };
  const ToolRun run = grab({}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("after the last shot"));
  for (const char* name : {"map.json", "map.glb", "mesh.ply", "trajectory.txt"})
    EXPECT_EQ(contentOf(out + "/" + name), contentOf(map_ + "/" + name)) << name;
  EXPECT_THAT(hiddenIn(out), IsEmpty());
  const ToolRun taken = grab({});
  EXPECT_EQ(taken.exit_code, 5);
  EXPECT_THAT(taken.err, HasSubstr("already holds"));
  const ToolRun twice = grab({"--pcd", folder_.path("clouds")});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_THAT(twice.err, HasSubstr("stages/replay"));
}

/** A folder stands where the file of the last observation belongs: it cannot be
 * written. */
TEST_F(ChainTest, AFaultOnTheWayEndsWithAMapOfWhatWasSeenBefore)
{
  const std::string out = folder_.path("faulty");
  fs::create_directories(out + "/stages/replay/observation_0002.pcd/x");
  const ToolRun run = runSessionChain(session_, out, {"--as-recorded"});
  EXPECT_EQ(run.exit_code, 5);
  EXPECT_THAT(run.err, HasSubstr("observation_0002.pcd"));
  EXPECT_THAT(run.err, HasSubstr("the map of the 2 observations by then is in " + out));
  EXPECT_TRUE(fs::exists(out + "/map.glb"));
  EXPECT_FALSE(fs::exists(out + "/stages/replay"));
}

TEST_F(ChainTest, AnXServerThatEndsCostsTheLiveWindowOnly)
{
  VirtualDisplay display("1280x960x24");
  if (!display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  const std::string out = folder_.path("seen");
  RunSettings seeing;
  seeing.environment = {{"DISPLAY", std::string(std::getenv("DISPLAY"))}};
  ToolRun run;
  {
    const StopAtFile stop(display, out + "/stages/replay/observation_0000.pcd");
    run = runSessionChain(session_, out, {"--as-recorded", "--live"}, seeing);
  }
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contentOf(out + "/map.glb") == contentOf(map_ + "/map.glb"));
}

TEST_F(ChainTest, OnlySessionsAreReplayed)
{
  const ToolRun live = runSessionChain(session_, folder_.path("out"), {"--live"});
  EXPECT_EQ(live.exit_code, 2);
  EXPECT_THAT(live.err, HasSubstr("--live: shows a session while it is replayed"));
  const ToolRun run = runChain(observations(), folder_.path("out"), {"--as-recorded"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("--as-recorded: is for raw sessions"));
  for (const char* option : {"--truth", "--poses"}) {
    const ToolRun refused =
        runChain(session_, folder_.path("out"), {"--as-recorded", option, session_});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr(option));
  }
  EXPECT_FALSE(fs::exists(folder_.path("out")));
}

TEST_F(ChainTest, TooManyPointsAreThinnedOverAllObservations)
{
  const std::string out = folder_.path("thin");
  const std::size_t all = jsonOfFile(map_ + "/report.json").at("finite_points");
  constexpr std::size_t maximum = 30000;
  ASSERT_GT(all, 2 * maximum);
  const ToolRun run =
      runChain(posedObservations(), out, {"--max-points", std::to_string(maximum)})
          .succeeded();
  std::size_t every = 1;
  while ((all + every - 1) / every > maximum)
    every *= 2;
  EXPECT_THAT(run.err, HasSubstr("--max-points"));
  EXPECT_THAT(run.err, HasSubstr("each " + std::to_string(every) + "th"));
  PCLPointCloud2 cloud;
  ASSERT_EQ(io::loadPCDFile(out + "/map.pcd", cloud), 0);
  EXPECT_EQ(cloud.width * cloud.height, (all + every - 1) / every);
  ASSERT_EQ(cloud.fields.back().name, "view");
  std::map<std::int32_t, std::size_t> seen_by;
  for (std::size_t row = 0; row < cloud.data.size(); row += cloud.point_step) {
    std::int32_t view = -1;
    std::memcpy(&view, &cloud.data[row + cloud.fields.back().offset], sizeof view);
    ++seen_by[view];
  }
  ASSERT_EQ(seen_by.size(), 3u);
  for (const auto& [view, points] : seen_by)
    EXPECT_GT(points, maximum / 10) << view;
}

} // namespace
} // namespace pcl::acmap::test
