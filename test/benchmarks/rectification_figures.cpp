#include "bench.h"
#include "rectification_peers.h"
#include "rectification_runs.h"

#include <pcl/core/impl/moments.h>
#include <pcl/simulation/standard_scenes.h>

#include <Eigen/Eigenvalues>

#include <array>
#include <functional>
#include <map>

namespace pcl::acmap::bench {
namespace {

constexpr std::uint64_t seeds = 3;
constexpr double failure = 0.5; ///< ratio above which the rectification of a map failed

using Maps = std::vector<RectificationMap>;
using Runs = std::vector<RectificationRun>;
using Configure = std::function<void(Rectification&)>;

std::string
textOf(double level)
{
  std::ostringstream text;
  text << level;
  return text.str();
}

/** Runs each map with each seed. */
Runs
runAll(const Maps& maps,
       double level,
       std::uint64_t last_seed,
       const Configure& configure = {})
{
  Runs runs;
  for (const RectificationMap& map : maps)
    for (std::uint64_t seed = 1; seed <= last_seed; ++seed) {
      runs.push_back(
          rectifyMap(map, drifted(map.truth, robotDrift(level), seed), configure));
      runs.back().name =
          map.name + ", x " + textOf(level) + ", " + std::to_string(seed);
      std::cerr << runs.back().name << ": " << runs.back().ratio() << "\n";
    }
  return runs;
}

/** Names of the runs whose ratio is above a limit. */
std::string
namesAbove(const Runs& runs, double ratio)
{
  std::ostringstream names;
  names.precision(2);
  for (const RectificationRun& run : runs)
    if (!(run.ratio() <= ratio))
      names << (names.tellp() > 0 ? "; " : "") << run.name << " (" << run.ratio()
            << ")";
  return names.tellp() > 0 ? names.str() : "none";
}

std::size_t
countAbove(const Runs& runs, double ratio)
{
  return static_cast<std::size_t>(
      std::count_if(runs.begin(), runs.end(), [ratio](const RectificationRun& run) {
        return !(run.ratio() <= ratio);
      }));
}

/** Targets for a group of runs. */
struct RunsReach {
  double median = no_reach, failures = no_reach, worse = no_reach, seconds = no_reach;
};

void
printRuns(const std::string& name,
          const Maps& maps,
          double level,
          const RunsReach& reach)
{
  const Runs runs = runAll(maps, level, seeds);
  const auto ratios = valuesOf(runs, [](auto& run) { return run.ratio(); });
  const auto aligned = valuesOf(runs, [](auto& run) { return run.alignedRatio(); });
  const auto seconds = valuesOf(runs, [](auto& run) { return run.seconds; });
  const auto refused = std::count_if(runs.begin(), runs.end(), [](auto& run) {
    return run.report.outcome == RectificationOutcome::Refused;
  });
  if (!runs.empty())
    Row() << name + ", x " + textOf(level) << runs.size()
          << atMost(median(ratios), reach.median, 3) << figure(largest(ratios), 3)
          << atMost(countAbove(runs, failure), reach.failures, 0)
          << atMost(countAbove(runs, 1), reach.worse, 0) << refused
          << figure(median(aligned), 3) << figure(largest(aligned), 3)
          << figure(median(seconds), 1) << atMost(largest(seconds), reach.seconds, 1)
          << namesAbove(runs, failure);
}

const Section logs_section("logs", [] {
  constexpr double none = 0, seconds = 15;
  const Maps logs = makeLogMaps(), long_logs = makeLongLogMaps();
  printHead(
      "maps, drift | runs | ratio, median | worst | above 0.5 | worse than before "
      "| refused | aligned, median | worst | CPU s, median | most | those above "
      "0.5");
  for (const double level : {0.5, 1.0, 2.0})
    printRuns("logs", logs, level, {level < 1 ? 0.15 : 0.1, none, no_reach, seconds});
  for (const double level : {0.5, 1.0, 2.0})
    printRuns("infinite-corridor", long_logs, level, {0.2, none, no_reach, seconds});
  const RunsReach strong{no_reach, no_reach, none, no_reach};
  printRuns("logs", logs, 4, strong);
  printRuns("infinite-corridor", long_logs, 4, strong);
});

const Section paper_section("paper", [] {
  printHead("map, drift | ratio of each seed | median | aligned, median | worst | CPU "
            "s, median");
  Maps maps = makeLogMaps();
  for (const RectificationMap& map : makeLongLogMaps())
    maps.push_back(map);
  for (const double level : {0.5, 1.0, 2.0})
    for (const RectificationMap& map : maps) {
      const Runs runs = runAll({map}, level, seeds, [](Rectification& rectification) {
        rectification.setMode(RectificationMode::Paper);
      });
      std::ostringstream each;
      each.precision(3);
      for (const RectificationRun& run : runs)
        each << (each.tellp() > 0 ? ", " : "") << std::fixed << run.ratio();
      const auto aligned = valuesOf(runs, [](auto& run) { return run.alignedRatio(); });
      Row() << map.name + ", x " + textOf(level) << each.str()
            << figure(median(valuesOf(runs, [](auto& run) { return run.ratio(); })), 3)
            << figure(median(aligned), 3) << figure(largest(aligned), 3)
            << figure(median(valuesOf(runs, [](auto& run) { return run.seconds; })), 1);
    }
});

void
printUnmoved(const RectificationMap& map)
{
  const RectificationRun run = rectifyMap(map, map.truth);
  Row() << map.name << nameOf(run.report.outcome)
        << atMost(largest(run.report.moved), map.bin_size / 2, 3)
        << figure(run.after.unaligned, 3) << figure(run.after.aligned, 3)
        << figure(run.seconds, 1);
}

const Section perfect_section("perfect", [] {
  printHead("map | outcome | farthest move, m | rms, m | aligned | CPU s");
  for (const RectificationMap& map : makeLogMaps())
    printUnmoved(map);
  for (const char* scene : {"corridor", "l_corridor", "loop"})
    printUnmoved(makeSceneMap(standardScene(scene)));
});

/** -1 for the left wall, 1 for the right wall, 0 for other points: recessed doors,
 * boxes, floor. */
int
wallOf(const PointNormal& point, const Eigen::Isometry3d& T_scene_camera)
{
  constexpr double half_width = 1.2, tolerance = 0.04; // metres
  constexpr double min_cosine = 0.95;
  const Eigen::Vector3d place = T_scene_camera * point.getVector3fMap().cast<double>();
  const Eigen::Vector3d normal =
      T_scene_camera.linear() * point.getNormalVector3fMap().cast<double>();
  if (!(std::abs(normal.x()) > min_cosine) ||
      !(std::abs(std::abs(place.x()) - half_width) < tolerance))
    return 0;
  return place.x() > 0 ? 1 : -1;
}

/** Common direction of both walls in some observations, in radians from z. */
double
directionOf(const RectificationMap& map,
            const std::vector<PlanarPose>& poses,
            std::size_t begin,
            std::size_t end)
{
  std::array<Moments, 2> walls;
  for (std::size_t i = begin; i < end; ++i) {
    const Eigen::Isometry3d truth = isometryOf(map.truth[i]);
    const Eigen::Isometry3d pose = isometryOf(poses[i]);
    for (const PointNormal& point : *map.clouds[i])
      if (const int wall = wallOf(point, truth))
        walls[wall > 0] += momentsOf(pose * point.getVector3fMap().cast<double>());
  }
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Moments& sums : walls)
    if (sums.count > 0) {
      Eigen::Matrix2d products;
      products << sums.xx, sums.xz, sums.xz, sums.zz;
      const Eigen::Vector2d sum(sums.x, sums.z);
      scatter += products - sum * sum.transpose() / sums.count;
    }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(scatter);
  const Eigen::Vector2d along = solver.eigenvectors().col(1);
  return std::atan(along[0] / along[1]);
}

/** Bending of a straight corridor along z: the angle between its walls in the first and in
 * the last third of the observations, degrees.
 * \param[in] map of the scene `corridor`; its true poses define which points belong to
 * the walls */
double
bowOf(const RectificationMap& map, const std::vector<PlanarPose>& poses)
{
  const std::size_t size = poses.size();
  const double bend = directionOf(map, poses, size - size / 3, size) -
                      directionOf(map, poses, 0, size / 3);
  return std::abs(bend) / degree;
}

/** Distance from the first to the last pose. */
double
lengthOf(const std::vector<PlanarPose>& poses)
{
  return std::hypot(poses.back().x - poses.front().x, poses.back().z - poses.front().z);
}

/** Relative difference of these distances, percent. */
double
excess(const std::vector<PlanarPose>& poses, const std::vector<PlanarPose>& other)
{
  return 100 * (lengthOf(poses) / lengthOf(other) - 1);
}

/** Runs of acmap and of the peers on a scene. */
struct CorridorRuns {
  RectificationMap map;
  std::vector<RectificationRun> ours;
  std::vector<std::vector<PlanarPose>> lum_poses;
};

CorridorRuns
printScene(const std::string& scene)
{
  constexpr std::uint64_t seeds = 3;
  constexpr double max_ratio = 0.3;
  CorridorRuns runs{makeSceneMap(standardScene(scene)), {}, {}};
  const RectificationMap& map = runs.map;
  std::vector<double> lum, lum_seconds, elch, elch_seconds;
  std::map<std::string, int> outcomes;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const std::vector<PlanarPose> given = drifted(map.truth, cameraDrift(), seed);
    runs.ours.push_back(rectifyMap(map, given));
    ++outcomes[nameOf(runs.ours.back().report.outcome)];
    const auto ratioOf = [&](const PeerRun& run) {
      return absoluteTrajectoryError(planarPartsOf(run.poses), map.truth).unaligned /
             runs.ours.back().before.unaligned;
    };
    const PeerRun by_lum = runLum(map.clouds, isometriesOf(given), truePairs(map));
    runs.lum_poses.push_back(planarPartsOf(by_lum.poses));
    lum.push_back(ratioOf(by_lum));
    lum_seconds.push_back(by_lum.seconds);
    if (scene == "loop") {
      const PeerRun by_elch = runElch(map.clouds, isometriesOf(given));
      elch.push_back(ratioOf(by_elch));
      elch_seconds.push_back(by_elch.seconds);
    }
  }
  const auto ratios = valuesOf(runs.ours, [](auto& run) { return run.ratio(); });
  std::string of_runs;
  for (const auto& [name, count] : outcomes)
    of_runs += (of_runs.empty() ? "" : ", ") + std::to_string(count) + " " + name;
  Row row;
  row << scene << atMost(median(ratios), max_ratio, 3)
      << atMost(largest(ratios), max_ratio, 3)
      << figure(
             median(valuesOf(runs.ours, [](auto& run) { return run.alignedRatio(); })),
             3)
      << of_runs
      << figure(median(valuesOf(runs.ours, [](auto& run) { return run.seconds; })), 1)
      << figure(median(lum), 3) << figure(median(lum_seconds), 1);
  if (elch.empty())
    row << "no loop | ";
  else
    row << figure(median(elch), 3) << figure(median(elch_seconds), 1);
  return runs;
}

const Section corridors_section("corridors", [] {
  constexpr double max_degrees = 0.3;
  printHead("scene | ratio, median | worst | aligned, median | outcomes | CPU s | LUM: "
            "ratio, median | CPU s | ELCH: ratio, median | CPU s");
  const CorridorRuns straight = printScene("corridor");
  printScene("l_corridor");
  printScene("loop");
  const RectificationMap& map = straight.map;
  printHead("corridor, seed | bow before, degrees | after | after LUM | length before, "
            "% too long | after | after LUM");
  for (std::size_t i = 0; i < straight.ours.size(); ++i) {
    const RectificationRun& run = straight.ours[i];
    Row() << i + 1 << figure(bowOf(map, run.given), 2)
          << atMost(bowOf(map, run.found), max_degrees, 2)
          << figure(bowOf(map, straight.lum_poses[i]), 2)
          << figure(excess(run.given, map.truth), 2)
          << figure(excess(run.found, map.truth), 2)
          << figure(excess(straight.lum_poses[i], map.truth), 2);
  }
});

/** Nothing tells where along it the camera is: its length should stay as the odometry has
 * it. */
const Section bare_corridor_section("corridors", [] {
  constexpr std::uint64_t seeds = 5;
  constexpr double max_percent = 1;
  const RectificationMap map = makeSceneMap(bareCorridor());
  printHead("bare corridor, seed | after, % longer than the odometry has it");
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const RectificationRun run =
        rectifyMap(map, drifted(map.truth, cameraDrift(), seed));
    Row() << seed << within(excess(run.found, run.given), max_percent, 2);
  }
});

} // namespace
} // namespace pcl::acmap::bench
