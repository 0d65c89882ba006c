#include "json_file.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

ToolRun
runRig(const std::vector<std::string>& arguments, const RunSettings& settings = {})
{
  return runTool(ACMAP_SIMULATED_RIG, arguments, settings);
}

/** A room that is simulated quickly. */
constexpr const char* room = R"(name: room
rig: {width: 64, height: 48, focal_length: 52, center_x: 31.5, center_y: 23.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
sensor: {reach: 6, points: 1500}
looks:
  wall: {color: [150, 140, 130], texture: 2}
surfaces:
  - rectangle: {name: wall, corner: [-9, 9, 3], edges: [[18, 0, 0], [0, -18, 0]], look: wall}
  - box: {name: box, least: [-0.5, -0.5, 2], most: [0.5, 0.5, 2.5], look: wall}
path:
  - line: {from: [-0.5, 0, -0.5], to: [-0.5, 0, 1], views: 4, yaw: [10, -10]}
)";

class SimulatedRig : public testing::Test {
protected:
  std::vector<std::string>
  arguments(const std::vector<std::string>& more = {}) const
  {
    return joined({"-o", session_, "--scene", scene_, "--clouds"}, more);
  }

  std::string
  inSession(const std::string& name) const
  {
    return session_ + "/" + name;
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("room.yaml", room);
  std::string session_ = folder_.path("session");
};

float
valueOf(const PCLPointCloud2& cloud, std::size_t point, const char* name)
{
  float value = std::nanf("");
  for (const PCLPointField& field : cloud.fields)
    if (field.name == name)
      std::memcpy(
          &value, &cloud.data[point * cloud.point_step + field.offset], sizeof(value));
  return value;
}

TEST_F(SimulatedRig, WritesASessionThatOthersRead)
{
  const ToolRun run = runRig(arguments()).succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("points:      6000"));
  const Trajectory trajectory = loadTrajectory(inSession("trajectory.txt"));
  ASSERT_EQ(trajectory.poses.size(), 4u);
  EXPECT_TRUE(trajectory.poses[0].matrix().isIdentity(0));
  EXPECT_EQ(loadTrinocularRig(inSession("rig.yaml")).focal_length, 52.0);
  for (std::size_t view = 0; view < 4; ++view) {
    const std::string path =
        inSession("observation_000" + std::to_string(view) + ".pcd");
    const PointCloudFile file = loadPointCloud(path);
    EXPECT_EQ(file.cloud.width, 64u);
    EXPECT_EQ(file.cloud.height, 48u);
    const Eigen::Isometry3d& pose = trajectory.poses[view];
    EXPECT_LT((file.sensor_origin.cast<double>() - pose.translation()).norm(), 1e-6);
    EXPECT_TRUE(file.sensor_orientation.cast<double>().toRotationMatrix().isApprox(
        pose.linear(), 1e-6));
    PointCloud<PointXYZRGBL> by_pcl;
    ASSERT_EQ(io::loadPCDFile(path, by_pcl), 0);
    std::size_t finite = 0;
    for (const PointXYZRGBL& point : by_pcl) {
      EXPECT_NEAR(point.r, 150, 15);
      EXPECT_EQ(std::isfinite(point.x), point.label > 0);
      finite += std::isfinite(point.x) ? 1 : 0;
    }
    EXPECT_EQ(finite, 1500u);
  }
}

TEST_F(SimulatedRig, CloudsHaveAllPointsIfTheseAreAskedFor)
{
  const ToolRun run = runRig(arguments({"--all-points"})).succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("points:      12288")) << "each pixel of 64 x 48";
  PointCloud<PointXYZ> cloud;
  ASSERT_EQ(io::loadPCDFile(inSession("observation_0003.pcd"), cloud), 0);
  for (const PointXYZ& point : cloud)
    EXPECT_TRUE(std::isfinite(point.x));
}

TEST_F(SimulatedRig, TruthIsOfTheMapFrame)
{
  runRig(arguments({"--quiet", "--seed", "7"})).succeeded();
  const auto truth = jsonOfFile(inSession("truth.json"));
  EXPECT_EQ(truth["scene"], "room");
  EXPECT_EQ(truth["version"], ACMAP_VERSION);
  EXPECT_EQ(truth["seed"], 7);
  EXPECT_EQ(truth["noise"]["growth"], 0.0025);
  ASSERT_EQ(truth["planes"].size(), 7u);
  std::size_t points = 0;
  for (const auto& plane : truth["planes"]) {
    points += plane["points"].get<std::size_t>();
    const auto c = plane["coefficients"].get<std::vector<double>>();
    for (const auto& rectangle : plane["rectangles"])
      for (const auto& corner : rectangle) {
        const auto p = corner.get<std::vector<double>>();
        EXPECT_NEAR(c[0] * p[0] + c[1] * p[1] + c[2] * p[2] + c[3], 0.0, 1e-9);
      }
  }
  EXPECT_EQ(points, 6000u);
  // 3.5 m in front of the first camera, which looks 10 degrees to the right.
  const auto wall = truth["planes"][0]["coefficients"].get<std::vector<double>>();
  EXPECT_NEAR(wall[3], 3.5, 1e-9);
  EXPECT_NEAR(wall[2], -std::cos(10 * M_PI / 180), 1e-9);
}

TEST_F(SimulatedRig, MergedCloudHasTheFinitePointsOfAll)
{
  const std::string map = folder_.path("map.pcd");
  runRig(arguments({"--merged", map})).succeeded();
  PCLPointCloud2 cloud;
  ASSERT_EQ(io::loadPCDFile(map, cloud), 0);
  ASSERT_EQ(cloud.width * cloud.height, 6000u);
  const auto trajectory = loadTrajectory(inSession("trajectory.txt"));
  std::size_t next = 0;
  for (int view = 0; view < 4; ++view) {
    const auto file =
        loadPointCloud(inSession("observation_000" + std::to_string(view) + ".pcd"));
    for (std::size_t i = 0; i < file.points().size(); ++i) {
      const Eigen::Vector3f point = file.points()[i];
      if (!point.allFinite())
        continue;
      const Eigen::Vector3d in_map =
          trajectory.poses[static_cast<std::size_t>(view)] * point.cast<double>();
      for (const auto& [name, axis] : {std::pair{"x", 0}, {"y", 1}, {"z", 2}})
        EXPECT_NEAR(valueOf(cloud, next, name), in_map[axis], 1e-5);
      std::int32_t its_view = -1;
      const float bits = valueOf(cloud, next, "view");
      std::memcpy(&its_view, &bits, sizeof(bits));
      EXPECT_EQ(its_view, view);
      ++next;
    }
  }
  EXPECT_EQ(next, 6000u);
}

TEST_F(SimulatedRig, AnotherSeedIsAnotherSession)
{
  const auto bytes = [&](const std::vector<std::string>& more) {
    EXPECT_EQ(runRig(arguments(more)).exit_code, 0);
    std::string all;
    for (const char* name : {"observation_0000.pcd",
                             "observation_0002.pcd",
                             "trajectory.txt",
                             "truth.json"})
      all += contentOf(inSession(name));
    std::filesystem::remove_all(session_);
    return all;
  };
  EXPECT_NE(bytes({"--seed", "2"}), bytes({}));
}

TEST_F(SimulatedRig, FewerObservationsAreTheFirstOnes)
{
  runRig(arguments()).succeeded();
  const std::string all = session_;
  session_ = folder_.path("two");
  runRig(arguments({"--observations", "2"})).succeeded();
  EXPECT_EQ(contentOf(inSession("observation_0001.pcd")),
            contentOf(all + "/observation_0001.pcd"));
  EXPECT_FALSE(std::filesystem::exists(inSession("observation_0002.pcd")));
  EXPECT_EQ(loadTrajectory(inSession("trajectory.txt")).poses.size(), 2u);
}

TEST_F(SimulatedRig, KinectMakesCloudsOfRoundedDisparities)
{
  const ToolRun run =
      runRig(arguments({"--sensor", "kinect", "--observations", "2"})).succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(loadTrinocularRig(inSession("rig.yaml")).focal_length, 575.0);
  EXPECT_EQ(loadTrajectory(inSession("trajectory.txt")).poses.size(), 2u);
  const auto truth = jsonOfFile(inSession("truth.json"));
  EXPECT_EQ(truth["sensor"], "kinect");
  EXPECT_EQ(truth["noise"]["step"], 0.125);
  const PointCloudFile file = loadPointCloud(inSession("observation_0001.pcd"));
  std::string names;
  for (const PCLPointField& field : file.cloud.fields)
    names += field.name + " ";
  EXPECT_EQ(names, "x y z rgb label ");
  EXPECT_EQ(file.cloud.width, 640u);
  EXPECT_EQ(file.cloud.height, 480u);
  std::size_t finite = 0;
  const PointView points = file.points();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const Eigen::Vector3f point = points[i]; point.allFinite()) {
      ++finite;
      const double steps = 575.0 * 0.075 / static_cast<double>(point.z()) / 0.125;
      // for depths rounded to a millimetre
      const double slack = 0.0006 * steps / static_cast<double>(point.z());
      EXPECT_NEAR(steps, std::round(steps), slack);
    }
  EXPECT_GT(finite, 250000u);
  EXPECT_LT(finite, 632u * 480u); // there is no depth at the right border
}

TEST_F(SimulatedRig, StereoIsTheDefaultSensor)
{
  runRig(arguments()).succeeded();
  const std::string by_default =
      contentOf(inSession("observation_0001.pcd")) + contentOf(inSession("truth.json"));
  session_ = folder_.path("named");
  runRig(arguments({"--sensor", "stereo"})).succeeded();
  EXPECT_EQ(contentOf(inSession("observation_0001.pcd")) +
                contentOf(inSession("truth.json")),
            by_default);
}

TEST_F(SimulatedRig, HelpAndReport)
{
  const ToolRun help = runRig({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word : {"metres", "corridor", "--seed", "Exit codes"})
    EXPECT_THAT(help.out, HasSubstr(word));
  const std::string path = folder_.path("r.json");
  runRig(arguments({"--report", path})).succeeded();
  const auto report = jsonOfFile(path);
  EXPECT_EQ(report["tool"], "pcl_simulated_rig");
  EXPECT_EQ(report["points"], 6000);
  for (const char* step : {"read", "observe", "write"})
    EXPECT_GE(report["seconds"][step], 0.0);
}

TEST_F(SimulatedRig, SparseViewsAreTold)
{
  std::string text = room;
  text.replace(text.find("1500"), 4, "9999");
  scene_ = folder_.write("dense.yaml", text);
  const ToolRun run = runRig(arguments());
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("4 observations see too little"));
  EXPECT_THAT(run.err, HasSubstr("observation_0000.pcd"));
}

TEST_F(SimulatedRig, NonsenseIsRefused)
{
  expectRefused(runRig({}), 2, "--output");
  expectRefused(runRig({"-o", session_, "--merged", folder_.path("map.pcd")}),
                2,
                "--merged needs --clouds");
  expectRefused(
      runRig({"-o", session_, "--sensor", "kinect"}), 2, "--sensor needs --clouds");
  expectRefused(
      runRig({"-o", session_, "--all-points"}), 2, "--all-points needs --clouds");
  expectRefused(runRig(arguments({"--sensor", "kinect", "--all-points"})),
                2,
                "--all-points is for stereo");
  expectRefused(runRig({"-o", session_, "--clouds", "stray"}), 2, "--help");
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"--observations", "0"},
                                             {"--observations", "5"},
                                             {"--observations", "-1"},
                                             {"--observations", "x"},
                                             {"--seed", "-1"},
                                             {"--seed", "1.5"},
                                             {"--threads", "-2"},
                                             {"--sensor", "lidar"},
                                             {"--sensor", ""},
                                             {"--patterns", "10"},
                                             {"--patterns", "0"},
                                             {"--patterns", "101"}})
    expectRefused(runRig(arguments(words)), 2, "--help");
  for (const char* name : {"--scene", "--cameras", "--output"})
    expectRefused(runRig({"-o", session_, name, ""}), 2, name);
  expectRefused(runRig(arguments({"--seed", "-1"})),
                2,
                "--seed: -1 is no whole number from 0 on");
  EXPECT_FALSE(std::filesystem::exists(session_));
}

TEST_F(SimulatedRig, ScenesOfNoUseAreNamed)
{
  expectRefused(runRig({"-o", session_, "--clouds", "--scene", "castle"}),
                3,
                "castle: is no file, and no standard scene (corridor, ");
  scene_ = folder_.write("bad.yaml", std::string(room) + "  - jump: {}\n");
  expectRefused(runRig(arguments()), 3, "bad.yaml: line 12");
  std::string text = room;
  text.replace(text.find("reach: 6"), 8, "reach: 0.5");
  scene_ = folder_.write("dark.yaml", text);
  expectRefused(runRig(arguments()), 4, "dark.yaml");
  EXPECT_FALSE(std::filesystem::exists(session_));
}

TEST_F(SimulatedRig, OtherObservationsStay)
{
  std::filesystem::create_directory(session_);
  folder_.write("session/notes.txt", "mine");
  runRig(arguments()).succeeded();
  EXPECT_EQ(contentOf(inSession("notes.txt")), "mine");
  const std::string before = contentOf(inSession("observation_0000.pcd"));
  expectRefused(runRig(arguments({"--seed", "3"})), 5, "observation_0000.pcd");
  EXPECT_EQ(contentOf(inSession("observation_0000.pcd")), before);
  session_ = folder_.path("other");
  std::filesystem::create_directory(session_);
  folder_.write("other/trajectory.txt", "0 0 0 0 0 0 0 1\n");
  expectRefused(runRig(arguments()), 5, "trajectory.txt");
}

TEST_F(SimulatedRig, PlacesThatCannotBeAreRefused)
{
  expectRefused(runRig({"-o", folder_.path("none/s"), "--clouds"}), 5, "none/s");
  expectRefused(runRig({"-o", scene_, "--clouds"}), 5, "is a file");
  expectRefused(runRig(arguments({"--merged", folder_.path("map.ply")})), 5, ".pcd");
  expectRefused(runRig(arguments({"--merged", inSession("observation_0001.pcd")})),
                2,
                "observation_0001.pcd");
  expectRefused(runRig(arguments({"--report", inSession("truth.json")})), 2, "truth");
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(SimulatedRig, FullDiskLeavesNothing)
{
  RunSettings full;
  full.file_size_limit = 20000;
  expectRefused(runRig(arguments(), full), 5, "observation_0000.pcd");
  full.file_size_limit = 100000; // enough for the observations, but not for the map
  expectRefused(
      runRig(arguments({"--merged", folder_.path("map.pcd")}), full), 5, "map.pcd");
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(SimulatedRig, InterruptionLeavesNothing)
{
  RunSettings interrupted;
  interrupted.interrupt_after = 0.5;
  const ToolRun run = runRig({"-o", session_, "--clouds"}, interrupted);
  expectRefused(run, 130, "interrupted");
  EXPECT_EQ(folder_.count(), 1);
}

} // namespace
} // namespace pcl::acmap::test
