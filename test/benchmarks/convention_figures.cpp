#include "bench.h"
#include "bench_data.h"
#include "laser_recording.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/pipeline/camera_path.h>
#include <pcl/pipeline/pose_convention_check.h>
#include <pcl/pipeline/rgbd_sequence.h>
#include <pcl/point_types.h>
#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace pcl::acmap::bench {
namespace {

using Poses = std::vector<Eigen::Isometry3d>;

/** A recording with poses that are right. */
struct Recording {
  std::string name;
  ObservationSequence views;
  Trajectory trajectory;
};

Recording
recordingOf(const std::string& name, const ObservationSequence& views)
{
  Trajectory trajectory;
  for (std::size_t i = 0; i < views.size(); ++i) {
    trajectory.stamps.push_back(views.stamp(i));
    trajectory.poses.push_back(views.pose(i));
  }
  return {name, views, std::move(trajectory)};
}

ObservationSequence
withPoses(const Recording& recording, const Poses& poses)
{
  std::vector<std::size_t> places(poses.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  return recording.views.withPoses(places, {recording.trajectory.stamps, poses});
}

std::vector<Recording>
realRecordings()
{
  std::vector<Recording> recordings;
  if (const auto kitchen = pathOfKitchen()) {
    const RgbdSequence recorded = openRgbdSequence(*kitchen);
    recordings.push_back(
        recordingOf("redkitchen", ObservationSequence(recorded, recorded.cameras())));
  }
  if (const auto scans = loadLaserScans())
    recordings.push_back(recordingOf("livox", *scans));
  return recordings;
}

std::vector<Recording>
simulatedRecordings(const std::vector<std::string>& scenes,
                    const test::TemporaryFolder& folder)
{
  std::vector<Recording> recordings;
  for (const std::string& scene : scenes) {
    const std::string views = folder.path(scene);
    test::runTool(ACMAP_SIMULATED_RIG, {"-o", views, "--scene", scene, "--clouds"})
        .succeeded();
    recordings.push_back(recordingOf(scene, ObservationSequence(views)));
  }
  return recordings;
}

/** Right poses with errors from one to the next, as the drift of ALGORITHMS 18: 2 % + 2 mm,
 * and .004 rad + 1 %, standard deviations. */
Poses
drifted(const Poses& poses, double times, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto noise = [&] {
    return Eigen::Vector3d(normal(random), normal(random), normal(random));
  };
  Poses drifting = {poses.front()};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    Eigen::Isometry3d step = poses[i - 1].inverse() * poses[i];
    const double length = step.translation().norm(),
                 angle = Eigen::AngleAxisd(step.linear()).angle();
    const Eigen::Vector3d turn = times * (0.004 + 0.01 * angle) * noise();
    step.translation() += times * (0.002 + 0.02 * length) * noise();
    if (turn.norm() > 0)
      step.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
    drifting.push_back(drifting.back() * step);
  }
  return drifting;
}

/** The poses as they would stand in a file of that convention and unit. */
Poses
recordedAs(const PoseReading& reading, const Poses& poses)
{
  Poses recorded;
  const Eigen::DiagonalMatrix<double, 3> opengl(1, -1, -1);
  for (Eigen::Isometry3d pose : poses) {
    if (reading.convention == PoseConvention::OpenGl ||
        reading.convention == PoseConvention::OpenGlWorldToCamera)
      pose.linear() = pose.linear() * opengl;
    if (reading.convention == PoseConvention::WorldToCamera ||
        reading.convention == PoseConvention::OpenGlWorldToCamera)
      pose = pose.inverse();
    pose.translation() /= reading.scale;
    recorded.push_back(pose);
  }
  return recorded;
}

const std::vector<PoseReading> wrong_readings = {
    {PoseConvention::WorldToCamera, 1},
    {PoseConvention::OpenGl, 1},
    {PoseConvention::CameraToWorld, 0.001},
    {PoseConvention::OpenGlWorldToCamera, 1},
    {PoseConvention::WorldToCamera, 0.001},
    {PoseConvention::OpenGl, 0.001}};

bool
isSame(const PoseReading& a, const PoseReading& b)
{
  return a.convention == b.convention && a.scale == b.scale;
}

const char*
answerOf(const PoseConventionReport& report, const PoseReading& truth)
{
  if (report.verdict != PoseVerdict::Contradicted)
    return "missed";
  if (!isSame(report.found, truth) &&
      std::none_of(report.equivalents.begin(),
                   report.equivalents.end(),
                   [&](const PoseReading& other) { return isSame(other, truth); }))
    return "wrong name";
  return report.equivalents.empty() ? "named" : "named with others";
}

struct Count {
  int named = 0, with_others = 0, wrong_name = 0, missed = 0;

  void
  add(const std::string& answer)
  {
    ++(answer == "named"               ? named
       : answer == "named with others" ? with_others
       : answer == "wrong name"        ? wrong_name
                                       : missed);
  }
};

void
printWrong(const std::vector<Recording>& recordings, double drift, Count& all)
{
  for (const Recording& recording : recordings) {
    const Poses poses = drifted(recording.trajectory.poses, drift, 1);
    for (const PoseReading& truth : wrong_readings) {
      PoseConventionCheck check;
      check.assess(withPoses(recording, recordedAs(truth, poses)));
      const PoseConventionReport& report = check.getReport();
      const std::string answer = answerOf(report, truth);
      all.add(answer);
      Row row;
      row << recording.name << figure(drift, 0) << textOf(truth) << answer
          << figure(report.margin, 0)
          << std::to_string(report.agreeing) + " of " + std::to_string(report.differing)
          << figure(milli * report.seconds.front().second, 0);
    }
  }
}

void
printRight(const std::vector<Recording>& recordings, std::size_t seeds, int& alarms)
{
  for (const Recording& recording : recordings)
    for (const double drift : {0, 1, 2})
      for (std::uint64_t seed = 1; seed <= (drift > 0 ? seeds : 1); ++seed) {
        PoseConventionCheck check;
        check.assess(
            withPoses(recording, drifted(recording.trajectory.poses, drift, seed)));
        const PoseConventionReport& report = check.getReport();
        alarms += report.verdict == PoseVerdict::Contradicted ? 1 : 0;
        Row row;
        row << recording.name << figure(drift, 0)
            << nameIn(pose_verdict_names, report.verdict) << textOf(report.found)
            << figure(report.margin, 0)
            << std::to_string(report.agreeing) + " of " +
                   std::to_string(report.differing);
      }
}

void
printFound()
{
  printHead("recording | drift | its poses are | answer | margin, nats | pairs that "
            "agree, of "
            "those that differ | ms");
  const test::TemporaryFolder folder;
  Count all;
  printWrong(realRecordings(), 0, all);
  printWrong(
      simulatedRecordings({"office", "loop", "l_corridor_drive"}, folder), 0, all);
  const Count exact = all;
  printWrong(realRecordings(), 2, all);
  printWrong(
      simulatedRecordings(
          {"corridor", "room", "corridor_drive", "corridor_survey", "l_corridor"},
          folder),
      0,
      all);
  Row row;
  row << "all without drift, named" << figure(0, 0)
      << atLeast(exact.named + exact.with_others, 30, 0) << "wrong name"
      << atMost(exact.wrong_name, 0, 0) << "missed" << atMost(exact.missed, 0, 0);
}

void
printAlarms()
{
  printHead(
      "recording | drift | verdict | found | margin, nats | pairs that agree, of those "
      "that differ");
  const test::TemporaryFolder folder;
  int alarms = 0;
  printRight(realRecordings(), 3, alarms);
  printRight(simulatedRecordings({"office",
                                  "loop",
                                  "l_corridor_drive",
                                  "corridor",
                                  "room",
                                  "corridor_drive",
                                  "corridor_survey",
                                  "l_corridor"},
                                 folder),
             1,
             alarms);
  Row row;
  row << "false alarms"
      << "" << atMost(alarms, 0, 0) << ""
      << ""
      << "";
}

/** What the path is, by poses that are right or drift. */
void
printPaths()
{
  printHead("recording | drift | is | found | tilt, degrees | rise, mm | places that "
            "tilt, of all");
  const test::TemporaryFolder folder;
  const auto print = [](const std::vector<Recording>& recordings, bool is_in_space) {
    for (const Recording& recording : recordings)
      for (const double drift : {0, 1, 2}) {
        const FreeMotion motion =
            freeMotionOf(drifted(recording.trajectory.poses, drift, 1));
        const CameraPathReport path = judgePath(motion);
        Row row;
        row << recording.name << figure(drift, 0)
            << (is_in_space ? "in space" : "planar")
            << (path.is_in_space ? "in space" : "planar")
            << figure(motion.tilt / degree, 2) << figure(milli * motion.rise, 0)
            << std::to_string(motion.free) + " of " + std::to_string(motion.pairs);
      }
  };
  print(realRecordings(), true);
  print(simulatedRecordings(standardSceneNames(), folder), false);
}

const Section paths_section("paths", printPaths);
const Section found_section("found", printFound);
const Section alarms_section("alarms", printAlarms);

} // namespace
} // namespace pcl::acmap::bench
