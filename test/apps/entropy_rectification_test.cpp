#include "json_file.h"
#include "mcap_file.h"
#include "rectification_runs.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <pcl/core/carmen_log.h>
#include <pcl/core/image_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/io/pcd_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

namespace pcl::acmap::test {

/** \brief A row of a map. */
struct PointOfMap {
  PCL_ADD_POINT4D
  PCL_ADD_RGB
  std::int32_t view;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

} // namespace pcl::acmap::test

POINT_CLOUD_REGISTER_POINT_STRUCT(
    pcl::acmap::test::PointOfMap,
    (float, x, x)(float, y, y)(float, z, z)(float, rgb, rgb)(std::int32_t, view, view))

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::set<std::string>
namesIn(const std::string& folder)
{
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

const std::set<std::string> all_outputs = {"trajectory.txt",
                                           "trajectory_before.txt",
                                           "map.pcd",
                                           "report.json",
                                           "plan_before.png",
                                           "plan_after.png",
                                           "plan.png",
                                           "energy.png"};

std::vector<std::string>
fieldsOf(const std::string& pcd)
{
  PCLPointCloud2 cloud;
  EXPECT_EQ(PCDReader().readHeader(pcd, cloud), 0);
  std::vector<std::string> names;
  for (const PCLPointField& field : cloud.fields)
    names.push_back(field.name);
  return names;
}

std::string
observationOf(const std::string& folder, std::size_t i)
{
  return folder + "/observation_00" + (i < 10 ? "0" : "") + std::to_string(i) + ".pcd";
}

/** Checks that the map consists of the observations at the poses of its trajectory. */
void
expectMap(const std::string& session, const std::string& output)
{
  const Trajectory trajectory = loadTrajectory(output + "/trajectory.txt");
  PointCloud<PointOfMap> map;
  ASSERT_EQ(io::loadPCDFile(output + "/map.pcd", map), 0);
  std::size_t row = 0;
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    PointCloud<PointXYZRGB> seen;
    ASSERT_EQ(io::loadPCDFile(observationOf(session, i), seen), 0);
    for (const PointXYZRGB& point : seen) {
      if (!point.getVector3fMap().allFinite())
        continue;
      ASSERT_LT(row, map.size());
      const PointOfMap& in_map = map[row++];
      const Eigen::Vector3d place =
          trajectory.poses[i] * point.getVector3fMap().cast<double>();
      ASSERT_LT((in_map.getVector3fMap().cast<double>() - place).norm(), 1e-5);
      ASSERT_EQ(in_map.rgba & 0xffffffU, point.rgba & 0xffffffU);
      ASSERT_EQ(in_map.view, static_cast<std::int32_t>(i));
    }
  }
  EXPECT_EQ(row, map.size());
}

TEST(RectificationTool, StraightensAFolder)
{
  const TemporaryFolder folder;
  const std::string output = folder.path("out put");
  const ToolRun run =
      runRectification({driftedRoom().session, "-o", output}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("rectified:"));
  EXPECT_EQ(namesIn(output), all_outputs);
  const Trajectory rectified = loadTrajectory(output + "/trajectory.txt");
  EXPECT_EQ(rectified.stamps, driftedRoom().truth.stamps);
  EXPECT_LT(meanError(rectified, driftedRoom().truth),
            0.6 * meanError(driftedRoom().drifted, driftedRoom().truth));
  const Trajectory before = loadTrajectory(output + "/trajectory_before.txt");
  EXPECT_EQ(before.stamps, rectified.stamps);
  EXPECT_LT(meanError(before, driftedRoom().drifted), 1e-6);
  expectMap(driftedRoom().session, output);
  const nlohmann::json report = reportOf(output);
  EXPECT_EQ(report.at("outcome"), "rectified");
  EXPECT_EQ(report.at("observations"), 24);
  EXPECT_EQ(report.at("moved").size(), 24U);
  EXPECT_LT(report.at("after").at("far_contradictions"),
            report.at("before").at("far_contradictions"));
}

/** Fractions for near and far observations, before and after, in %. */
TEST(RectificationTool, SharesOfRaysAreTold)
{
  const TemporaryFolder folder;
  const std::string output = folder.path("out");
  const ToolRun run =
      runRectification({driftedRoom().session, "-o", output}).succeeded();
  const nlohmann::json report = reportOf(output);
  // the reason follows the outcome, and contains no numbers
  const std::string reason = report.at("rectified");
  EXPECT_EQ(reason.find_first_of("0123456789"), std::string::npos) << reason;
  std::istringstream lines(run.out);
  std::size_t told = 0;
  for (std::string line; std::getline(lines, line);) {
    const bool is_contradicted = line.rfind("contradicted:", 0) == 0;
    if (!is_contradicted && line.rfind("confirmed:", 0) != 0)
      continue;
    const std::regex share("([0-9.e+-]+) % (before|after)");
    std::vector<double> shares;
    for (std::sregex_iterator i(line.begin(), line.end(), share), end; i != end; ++i)
      shares.push_back(std::stod((*i)[1]));
    ASSERT_EQ(shares.size(), 4U) << line;
    std::size_t next = 0;
    for (const char* distance : {"near", "far"})
      for (const char* time : {"before", "after"}) {
        const nlohmann::json& rays = report.at(time);
        const double contradicted =
            rays.at(std::string(distance) + "_contradictions").get<double>();
        const double confirmed =
            rays.at(std::string(distance) + "_rays").get<double>() * (1 - contradicted);
        const double wanted = 100 * (is_contradicted ? contradicted : confirmed);
        EXPECT_NEAR(shares[next], wanted, 0.01 * wanted) << line;
        EXPECT_LE(shares[next++], 100) << line;
      }
    ++told;
  }
  EXPECT_EQ(told, 2U) << run.out;
}

TEST(RectificationTool, PlansHaveOneScaleAndExtent)
{
  const TemporaryFolder folder;
  const std::string output = folder.path("out");
  runRectification({driftedRoom().session, "-o", output}).succeeded();
  const RgbImage before = loadRgbImage(output + "/plan_before.png");
  const RgbImage after = loadRgbImage(output + "/plan_after.png");
  const RgbImage both = loadRgbImage(output + "/plan.png");
  EXPECT_EQ(before.width, after.width);
  EXPECT_EQ(before.height, after.height);
  EXPECT_NE(before.values, after.values);
  EXPECT_EQ(both.height, before.height);
  EXPECT_GE(both.width, 2 * before.width);
  EXPECT_GT(loadRgbImage(output + "/energy.png").width, 100);
}

TEST(RectificationTool, ObservationsAreASequenceAgain)
{
  const TemporaryFolder folder;
  const std::string output = folder.path("out");
  runRectification({driftedRoom().session, "-o", output, "--observations"}).succeeded();
  const Trajectory rectified = loadTrajectory(output + "/trajectory.txt");
  for (std::size_t i = 0; i < rectified.poses.size(); ++i) {
    PCLPointCloud2 before, after;
    Eigen::Vector4f origin;
    Eigen::Quaternionf orientation;
    int version = 0;
    ASSERT_EQ(PCDReader().read(observationOf(driftedRoom().session, i), before), 0);
    ASSERT_EQ(
        PCDReader().read(observationOf(output, i), after, origin, orientation, version),
        0);
    EXPECT_EQ(before.data, after.data);
    EXPECT_EQ(before.height, after.height);
    EXPECT_LT(
        (origin.head<3>().cast<double>() - rectified.poses[i].translation()).norm(),
        1e-5);
    EXPECT_TRUE(orientation.toRotationMatrix().cast<double>().isApprox(
        rectified.poses[i].linear(), 1e-5));
  }
  // there is no warning about VIEWPOINTs, since they agree with the trajectory
  const ToolRun again = runRectification({output, "-o", folder.path("again")});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, Not(HasSubstr("VIEWPOINT")));
}

TEST(RectificationTool, StraightensALog)
{
  const TemporaryFolder folder;
  const std::string output = folder.path("out");
  const ToolRun run =
      runRectification({"--carmen", folder.write("a log", roomLog(true)), "-o", output})
          .succeeded();
  std::set<std::string> outputs = all_outputs;
  outputs.insert({"corrected.log", "poses_2d.txt"});
  EXPECT_EQ(namesIn(output), outputs);
  EXPECT_THAT(run.out, HasSubstr("60 of 60 scans, 10680 echoes, 120 beams without"));
  EXPECT_THAT(run.out, HasSubstr("rectified:"));
  const Trajectory rectified = loadTrajectory(output + "/trajectory.txt");
  const Trajectory truth = roomLogTruth();
  EXPECT_EQ(rectified.stamps, truth.stamps);
  EXPECT_LT(meanError(rectified, truth), 0.6 * meanError(withDrift(truth), truth));
  EXPECT_THAT(fieldsOf(output + "/map.pcd"), ElementsAre("x", "y", "z", "view"));
  PointCloud<PointXYZ> map;
  ASSERT_EQ(io::loadPCDFile(output + "/map.pcd", map), 0);
  EXPECT_EQ(map.size(), 10680U);
  for (const PointXYZ& point : map)
    ASSERT_EQ(point.y, 0);
  EXPECT_EQ(reportOf(output).at("missing_beams"), 120);
  const CarmenLog corrected = loadCarmenLog(output + "/corrected.log");
  ASSERT_EQ(corrected.scans.size(), 60U);
  for (std::size_t i = 0; i < 60; ++i)
    EXPECT_TRUE(isometryOf(corrected.scans[i].pose).isApprox(rectified.poses[i], 1e-9));
  const std::string table = contentOf(output + "/poses_2d.txt");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 61);
}

/** Turns of the other sign, whose maps no search straightens. */
TEST(RectificationTool, SetsAsideWhatItsOwnEvidenceContradicts)
{
  const TemporaryFolder folder;
  CarmenLog log = loadCarmenLog(folder.write("right.log", roomLog(false)));
  for (PlanarScan& scan : log.scans)
    scan.pose = {-scan.pose.x, scan.pose.z, -3 * scan.pose.theta};
  const std::string wrong = folder.path("wrong.log");
  saveCarmenLog(wrong, log.scans);
  const std::string output = folder.path("out"), aside = output + ".contradicted";
  for (int time = 0; time < 2;
       ++time) { // the second result takes the place of the first
    const ToolRun run = runRectification({"--carmen", wrong, "-o", output});
    EXPECT_EQ(run.exit_code, 7) << run.err;
    EXPECT_THAT(run.err, HasSubstr("contradict"));
    EXPECT_THAT(run.err, HasSubstr(aside));
    EXPECT_FALSE(fs::exists(output));
    EXPECT_EQ(reportOf(aside).at("verdict").at("outcome"), "contradicted");
  }
  fs::remove(aside + "/report.json");
  EXPECT_EQ(runRectification({"--carmen", wrong, "-o", output}).exit_code, 5)
      << "it may hold other files";
}

/** The scans of a log as a bag, whose odometry is the poses of the log. */
std::string
bagOf(const CarmenLog& log)
{
  McapWriter bag;
  for (const PlanarScan& scan : log.scans) {
    Eigen::Isometry3d pose(
        Eigen::AngleAxisd(-scan.pose.theta, Eigen::Vector3d::UnitZ()));
    pose.translation() << scan.pose.z, -scan.pose.x, 0;
    bag.add("/odom",
            "nav_msgs/msg/Odometry",
            scan.stamp,
            odometryMessage(scan.stamp, "odom", "base_scan", pose));
    bag.add("/scan",
            "sensor_msgs/msg/LaserScan",
            scan.stamp,
            scanMessage(scan.stamp,
                        "base_scan",
                        static_cast<float>(-scan.first_angle),
                        static_cast<float>(-scan.angle_step),
                        scan.ranges));
  }
  return bag.finish();
}

TEST(RectificationTool, StraightensTheScansOfABagAsThoseOfALog)
{
  const TemporaryFolder folder;
  const std::string log = folder.write("a log", roomLog(true));
  runRectification({"--carmen", log, "-o", folder.path("of_log")}).succeeded();
  const std::string bag = folder.write("robot.mcap", bagOf(loadCarmenLog(log)));
  const ToolRun run = runRectification({bag, "-o", folder.path("of_bag")}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("60 of 60 scans, 10680 echoes, 120 beams without"));
  const Trajectory of_log = loadTrajectory(folder.path("of_log/trajectory.txt"));
  const Trajectory of_bag = loadTrajectory(folder.path("of_bag/trajectory.txt"));
  EXPECT_LT(meanError(of_bag, of_log), 1e-3);
  const CarmenLog corrected = loadCarmenLog(folder.path("of_bag/corrected.log"));
  EXPECT_EQ(corrected.scans.size(), 60U);
  const auto refuse = [&](std::vector<std::string> options, const std::string& word) {
    options.insert(options.end(), {"-o", folder.path("none")});
    const ToolRun refused = runRectification(options);
    EXPECT_EQ(refused.exit_code, 2) << word;
    EXPECT_THAT(refused.err, HasSubstr(word));
  };
  refuse({bag, "--6dof"}, "--6dof is for a folder of observations");
  refuse({bag, "--laser-fov", "180"}, "--laser-fov");
  refuse({"--carmen", log, "--sensor-pose", "0,0,1"}, "--sensor-pose is for bags");
  refuse({bag, "--sensor-pose", "0,1"}, "three or six numbers");
}

TEST(RectificationTool, TheSweepOfALogIsToldAndMayBeStated)
{
  const TemporaryFolder folder;
  const std::string log = folder.write("a log", roomLog(true));
  const auto run = [&](const char* output, const std::vector<std::string>& more) {
    std::vector<std::string> options = {
        "--carmen", log, "--every", "20", "-o", folder.path(output)};
    options.insert(options.end(), more.begin(), more.end());
    return runRectification(options).succeeded();
  };
  EXPECT_THAT(run("assumed", {}).out,
              HasSubstr("180 degrees, a beam each 1 degrees, assumed; --laser-fov"));
  const ToolRun wide = run("stated", {"--laser-fov", "270"});
  EXPECT_THAT(wide.out, HasSubstr("270 degrees, a beam each 1.5 degrees, as stated"));
  EXPECT_THAT(wide.err, HasSubstr("as of no common laser"));
}

TEST(RectificationTool, TakesEachNthScan)
{
  const TemporaryFolder folder;
  const std::string log = folder.write("log", roomLog(false));
  runRectification({"--carmen", log, "--every", "7", "-o", folder.path("out")})
      .succeeded();
  const Trajectory rectified = loadTrajectory(folder.path("out/trajectory.txt"));
  ASSERT_EQ(rectified.stamps.size(), 9U);
  EXPECT_EQ(rectified.stamps[8], 10 + 56);
}

TEST(RectificationTool, ModesAndSeedsAreTold)
{
  const TemporaryFolder folder;
  const std::string log = folder.write("log", roomLog(true));
  runRectification({"--carmen",
                    log,
                    "--every",
                    "6",
                    "-o",
                    folder.path("out"),
                    "-mode",
                    "paper",
                    "--seed",
                    "7",
                    "--bin",
                    "0.2",
                    "--smoothing",
                    "0.3"})
      .succeeded();
  const nlohmann::json report = reportOf(folder.path("out"));
  EXPECT_EQ(report.at("mode"), "paper");
  EXPECT_EQ(report.at("seed"), 7);
  EXPECT_EQ(report.at("bin_size"), 0.2);
  EXPECT_EQ(report.at("smoothing"), 0.3);
  EXPECT_EQ(report.at("evaluations"), report.at("votes").get<int>() + 1);
  EXPECT_GT(report.at("accepted_moves"), 0);
}

Eigen::Vector3d
upOf(const nlohmann::json& report)
{
  const nlohmann::json& up = report.at("level").at("axis");
  return {up[0].get<double>(), up[1].get<double>(), up[2].get<double>()};
}

TEST(RectificationTool, AMapThatIsNotLevelIsTurned)
{
  const TemporaryFolder folder;
  const std::string session = copyOfRoom(folder.path("session"));
  Trajectory tilted = driftedRoom().truth;
  for (Eigen::Isometry3d& pose : tilted.poses)
    pose = Eigen::AngleAxisd(0.35, Eigen::Vector3d::UnitX()) * pose;
  saveTrajectory(session + "/trajectory.txt", tilted);
  const ToolRun run = runRectification({session, "-o", folder.path("out")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("-y, the y axis of cameras points down"));
  EXPECT_THAT(run.err, Not(HasSubstr("--6dof"))) << "the poses know the tilt";
  EXPECT_NEAR(reportOf(folder.path("out")).at("level").at("tilt_deg"), 20.05, 0.5);
  const Trajectory level = loadTrajectory(folder.path("out/trajectory.txt"));
  for (const Eigen::Isometry3d& pose : level.poses)
    EXPECT_GT(pose.linear()(1, 1), std::cos(0.01)) << "the camera is level";

  // the camera is tilted, but its poses rotate about y only, as those of a robot
  const std::string unknown = copyOfRoom(folder.path("unknown"));
  for (std::size_t i = 0; i < driftedRoom().truth.poses.size(); ++i) {
    PointCloudFile file = loadPointCloud(observationOf(unknown, i));
    const Eigen::AngleAxisf tilt(0.35F, Eigen::Vector3f::UnitX());
    for (std::size_t at = 0; at < file.cloud.data.size(); at += file.cloud.point_step) {
      Eigen::Vector3f place; // x, y, z are the first fields
      std::memcpy(place.data(), &file.cloud.data[at], sizeof place);
      place = tilt * place;
      std::memcpy(&file.cloud.data[at], place.data(), sizeof place);
    }
    savePointCloud(observationOf(unknown, i), file.cloud);
  }
  const ToolRun floor = runRectification({unknown, "-o", folder.path("floor")});
  EXPECT_EQ(floor.exit_code, 0) << floor.err;
  EXPECT_THAT(floor.err, HasSubstr("again with --6dof"));
}

/** Largest error of the heights, metres. */
double
heightError(const Trajectory& found, const Trajectory& truth)
{
  double largest = 0;
  for (std::size_t i = 0; i < truth.poses.size(); ++i)
    largest = std::max(largest,
                       std::abs(found.poses.at(i).translation().y() -
                                truth.poses[i].translation().y()));
  return largest;
}

TEST(RectificationTool, SixDegreesOfFreedomMendHeightsToo)
{
  const TemporaryFolder folder;
  const std::string session = copyOfRoom(folder.path("session"));
  const Trajectory truth = driftedRoom().truth;
  Trajectory climbing = truth;
  Eigen::Isometry3d drift = Eigen::Isometry3d::Identity();
  for (Eigen::Isometry3d& pose : climbing.poses) {
    pose = pose * drift;
    drift.translate(Eigen::Vector3d(0, 0.01, 0));
    drift.rotate(Eigen::AngleAxisd(0.002, Eigen::Vector3d::UnitX()));
  }
  saveTrajectory(session + "/trajectory.txt", climbing);
  double before = 0;
  for (const bool adjusts : {false, true}) {
    const std::string output = folder.path(adjusts ? "adjusted" : "rectified");
    std::vector<std::string> arguments = {session, "-o", output, "--up", "-y"};
    if (adjusts)
      arguments.emplace_back("--6dof");
    const ToolRun run = runRectification(arguments).succeeded();
    const double height =
        heightError(loadTrajectory(output + "/trajectory.txt"), truth);
    const nlohmann::json report = reportOf(output);
    EXPECT_EQ(report.contains("adjustment"), adjusts);
    if (!adjusts) {
      EXPECT_GT(height, 0.1) << "the entropy keeps heights";
      before = height;
      continue;
    }
    EXPECT_LT(height, 0.4 * before) << "views of 96 x 72 pixels, half of them of walls";
    EXPECT_THAT(run.out, HasSubstr("planes adjusted:"));
    EXPECT_THAT(run.out, HasSubstr("thickness:"));
    expectMap(session, output);
    const nlohmann::json& adjustment = report.at("adjustment");
    EXPECT_EQ(adjustment.at("outcome"), "adjusted");
    EXPECT_EQ(adjustment.at("moved").size(), truth.poses.size());
    EXPECT_EQ(adjustment.at("uncertainty").size(), truth.poses.size());
    EXPECT_LT(adjustment.at("thickness_after").get<double>(),
              0.3 * adjustment.at("thickness_before").get<double>());
    EXPECT_GT(adjustment.at("significance"), 5);
    EXPECT_GT(adjustment.at("rounds").at(0).at("landmarks"), 0);
  }
}

TEST(RectificationTool, SixDegreesOfFreedomKeepPosesThatFit)
{
  const TemporaryFolder folder;
  const std::string session = copyOfRoom(folder.path("session"));
  const Trajectory truth = driftedRoom().truth;
  saveTrajectory(session + "/trajectory.txt", truth);
  runRectification({session, "-o", folder.path("out"), "--up", "-y", "--6dof"})
      .succeeded();
  EXPECT_LT(heightError(loadTrajectory(folder.path("out/trajectory.txt")), truth),
            0.01);
}

TEST(RectificationTool, SixDegreesOfFreedomAreNotForALog)
{
  const TemporaryFolder folder;
  const ToolRun run = runRectification({"--carmen",
                                        folder.write("scans.log", roomLog(false)),
                                        "-o",
                                        folder.path("out"),
                                        "--6dof"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("--6dof"));
}

TEST(RectificationTool, TheVerticalMayBeZOrGiven)
{
  const TemporaryFolder folder;
  const std::string session = copyOfRoom(folder.path("session"));
  Trajectory upright = driftedRoom().truth; // in a map whose z points up
  for (Eigen::Isometry3d& pose : upright.poses)
    pose = Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitX()) * pose;
  saveTrajectory(session + "/trajectory.txt", upright);
  const ToolRun found = runRectification({session, "-o", folder.path("z")});
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_EQ(upOf(reportOf(folder.path("z"))), Eigen::Vector3d::UnitZ());
  const Trajectory poses = loadTrajectory(folder.path("z/trajectory.txt"));
  for (std::size_t i = 0; i < poses.poses.size(); ++i)
    EXPECT_LT((poses.poses[i].translation() - upright.poses[i].translation()).norm(),
              0.1);
  const RgbImage plan = loadRgbImage(folder.path("z/plan_before.png"));
  saveTrajectory(session + "/trajectory.txt", driftedRoom().truth);
  runRectification({session, "-o", folder.path("y")}).succeeded();
  const RgbImage level_plan = loadRgbImage(folder.path("y/plan_before.png"));
  EXPECT_NEAR(plan.height, level_plan.height, 20) << "drawn from above";
  EXPECT_NEAR(plan.width, level_plan.width, 20);

  const ToolRun given =
      runRectification({session, "-o", folder.path("given"), "--up", "0,-1,0.1"});
  EXPECT_EQ(given.exit_code, 0) << given.err;
  EXPECT_NEAR(reportOf(folder.path("given")).at("level").at("tilt_deg"), 5.71, 0.01);
  EXPECT_EQ(
      runRectification({session, "-o", folder.path("axis"), "--up", "-y"}).exit_code,
      0);
  for (const char* bad : {"up", "0,0,0", "1,2", "1,2,3,4", "nan,0,1", ""})
    EXPECT_EQ(
        runRectification({session, "-o", folder.path("bad"), "--up", bad}).exit_code, 2)
        << bad;
}

} // namespace
} // namespace pcl::acmap::test
