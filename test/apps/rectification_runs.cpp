#include "rectification_runs.h"

#include "temporary_folder.h"

#include <pcl/core/planar_pose.h>
#include <pcl/core/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace pcl::acmap::test {

namespace {

constexpr double pi = 3.14159265358979323846;

/** A room of 7 m by 5 m with a pillar and a cupboard; the camera moves along a line
 * while it looks around. */
constexpr const char* room = R"(name: room
rig: {width: 96, height: 72, focal_length: 78, center_x: 47.5, center_y: 35.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
sensor: {reach: 9, points: 5000}
looks:
  wall: {color: [150, 140, 130], texture: 2}
surfaces:
  - rectangle: {name: back, corner: [-3, -1.5, 3],
                edges: [[7, 0, 0], [0, 2.7, 0]], look: wall}
  - rectangle: {name: front, corner: [-3, -1.5, -2],
                edges: [[7, 0, 0], [0, 2.7, 0]], look: wall}
  - rectangle: {name: left, corner: [-3, -1.5, -2],
                edges: [[0, 0, 5], [0, 2.7, 0]], look: wall}
  - rectangle: {name: right, corner: [4, -1.5, -2],
                edges: [[0, 0, 5], [0, 2.7, 0]], look: wall}
  - rectangle: {name: floor, corner: [-3, 1.2, -2],
                edges: [[7, 0, 0], [0, 0, 5]], look: wall}
  - box: {name: pillar, least: [1.5, -1.5, 1.6], most: [2, 1.2, 2.1], look: wall}
  - box: {name: cupboard, least: [-3, -0.3, 0], most: [-2.4, 1.2, 1.2], look: wall}
path:
  - line: {from: [-1.6, 0, -1], to: [2.4, 0, 0.9], views: 24,
           yaw: [0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330]}
)";

/** Distance to the wall or the pillar (radius 0.4 m, at 6, 3) along a direction. */
double
rangeInRoom(double x, double y, double angle)
{
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  double range = std::min(((dx > 0 ? 9 : 0) - x) / dx, ((dy > 0 ? 6 : 0) - y) / dy);
  const double along = (6 - x) * dx + (3 - y) * dy;
  const double inside = 0.16 - std::pow((6 - x) * dy - (3 - y) * dx, 2);
  if (along > 0 && inside > 0)
    range = std::min(range, along - std::sqrt(inside));
  return range;
}

/** A pose in the frame of the log: x forward, y to the left. */
std::array<double, 3>
logPoseOf(const Eigen::Isometry3d& T_map_laser)
{
  const PlanarPose pose = planarPartOf(T_map_laser);
  return {pose.z, -pose.x, -pose.theta};
}

} // namespace

ToolRun
runRectification(const std::vector<std::string>& arguments, const RunSettings& settings)
{
  return runTool(ACMAP_ENTROPY_RECTIFICATION, arguments, settings);
}

const DriftedRoom&
driftedRoom()
{
  static const TemporaryFolder folder;
  static const DriftedRoom made = [] {
    DriftedRoom room_of_run;
    room_of_run.session = folder.path("session");
    const ToolRun rig = runTool(ACMAP_SIMULATED_RIG,
                                {"-o",
                                 room_of_run.session,
                                 "--scene",
                                 folder.write("room.yaml", room),
                                 "--clouds"});
    EXPECT_EQ(rig.exit_code, 0) << rig.err;
    const std::string path = room_of_run.session + "/trajectory.txt";
    room_of_run.truth = loadTrajectory(path);
    room_of_run.drifted = withDrift(room_of_run.truth);
    saveTrajectory(path, room_of_run.drifted);
    return room_of_run;
  }();
  return made;
}

std::string
copyOfRoom(const std::string& folder)
{
  std::filesystem::copy(driftedRoom().session, folder);
  return folder;
}

Trajectory
withDrift(const Trajectory& trajectory)
{
  Trajectory drifted = trajectory;
  for (std::size_t i = 1; i < trajectory.poses.size(); ++i) {
    Eigen::Isometry3d action = trajectory.poses[i - 1].inverse() * trajectory.poses[i];
    action.translation() *= 1.03;
    action.rotate(Eigen::AngleAxisd(0.012, Eigen::Vector3d::UnitY()));
    drifted.poses[i] = drifted.poses[i - 1] * action;
  }
  return drifted;
}

double
meanError(const Trajectory& a, const Trajectory& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.poses.size(); ++i)
    sum += (a.poses[i].translation() - b.poses.at(i).translation()).norm();
  return sum / static_cast<double>(a.poses.size());
}

Trajectory
roomLogTruth()
{
  Trajectory truth;
  for (int i = 0; i < 60; ++i) {
    const double turned = 2 * pi * i / 60;
    // around the centre (4.5, 3), looking forward
    const double x = 4.5 + 2.8 * std::cos(turned);
    const double y = 3 + 1.8 * std::sin(turned);
    const double theta = std::atan2(1.8 * std::cos(turned), -2.8 * std::sin(turned));
    truth.stamps.push_back(10 + i);
    truth.poses.push_back(isometryOf({-y, x, -theta}));
  }
  return truth;
}

std::string
roomLog(bool drifts)
{
  const Trajectory truth = roomLogTruth();
  const Trajectory told = drifts ? withDrift(truth) : truth;
  Random random(6);
  std::ostringstream log;
  log.precision(12);
  log << "# made\nPARAM robot_length 0.5 0 host 0\n";
  for (std::size_t i = 0; i < truth.poses.size(); ++i) {
    const auto [x, y, theta] = logPoseOf(truth.poses[i]);
    log << "FLASER 180";
    for (int beam = 0; beam < 180; ++beam) {
      const double range = rangeInRoom(x, y, theta + (beam - 90) * pi / 180);
      log << " " << (beam < 2 ? 81.83 : range + 0.01 * random.normal());
    }
    for (const double value : logPoseOf(told.poses[i]))
      log << " " << value;
    log << " 0 0 0 " << truth.stamps[i] << " host " << truth.stamps[i] << "\n";
  }
  return log.str();
}

} // namespace pcl::acmap::test
