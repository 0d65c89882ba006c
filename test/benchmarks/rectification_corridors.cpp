#include "rectification_tables.h"

#include "corridor_bow.h"
#include "markdown_row.h"
#include "rectification_peers.h"
#include "rectification_runs.h"
#include "statistics.h"

#include <pcl/simulation/standard_scenes.h>

#include <cmath>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

/** A run of acmap and of the peers. */
struct CorridorRun {
  RectificationRun ours;
  std::vector<PlanarPose> lum_poses;
  double lum_seconds = 0, elch_seconds = 0;
  double lum_ratio = 0, elch_ratio = no_reach;
};

CorridorRun
runCorridor(const RectificationMap& map,
            std::uint64_t seed,
            const ObservationPairs& pairs,
            bool is_loop)
{
  const std::vector<PlanarPose> given = drifted(map.truth, cameraDrift(), seed);
  CorridorRun run;
  run.ours = rectifyMap(map, given);
  run.ours.name = map.name + ", " + std::to_string(seed);
  const double before = run.ours.before.unaligned;
  const std::vector<Eigen::Isometry3d> in_space = isometriesOf(given);
  const PeerRun lum = runLum(map.clouds, in_space, pairs);
  run.lum_poses = planarPartsOf(lum.poses);
  run.lum_seconds = lum.seconds;
  run.lum_ratio = absoluteTrajectoryError(run.lum_poses, map.truth).unaligned / before;
  if (is_loop) {
    const PeerRun elch = runElch(map.clouds, in_space);
    run.elch_seconds = elch.seconds;
    run.elch_ratio =
        absoluteTrajectoryError(planarPartsOf(elch.poses), map.truth).unaligned /
        before;
  }
  return run;
}

void
printCorridorRun(const CorridorRun& run, bool is_loop)
{
  constexpr double max_ratio = 0.3;
  MarkdownRow row;
  row.text(run.ours.name)
      .number(run.ours.before.unaligned, 3)
      .number(run.ours.after.unaligned, 3)
      .atMost(run.ours.ratio(), max_ratio, 3)
      .number(run.ours.alignedRatio(), 3)
      .text(nameOf(run.ours.report.outcome))
      .number(run.ours.report.odometry_scale, 0)
      .number(run.ours.seconds, 1)
      .atLeast(run.lum_ratio, is_loop ? no_reach : run.ours.ratio(), 3)
      .number(run.lum_seconds, 1);
  if (is_loop)
    row.number(run.elch_ratio, 3).number(run.elch_seconds, 1);
  else
    row.text("no loop").text("");
  row.print();
}

void
printMedians(const std::string& name,
             const std::vector<CorridorRun>& runs,
             bool is_loop)
{
  std::vector<double> ours, aligned, seconds, lum, lum_seconds, elch, elch_seconds;
  for (const CorridorRun& run : runs) {
    ours.push_back(run.ours.ratio());
    aligned.push_back(run.ours.alignedRatio());
    seconds.push_back(run.ours.seconds);
    lum.push_back(run.lum_ratio);
    lum_seconds.push_back(run.lum_seconds);
    elch.push_back(run.elch_ratio);
    elch_seconds.push_back(run.elch_seconds);
  }
  MarkdownRow row;
  row.text(name + ", median")
      .text("")
      .text("")
      .number(median(ours), 3)
      .number(median(aligned), 3)
      .text("")
      .text("")
      .number(median(seconds), 1)
      .number(median(lum), 3)
      .number(median(lum_seconds), 1);
  if (is_loop)
    row.number(median(elch), 3).number(median(elch_seconds), 1);
  else
    row.text("no loop").text("");
  row.print();
}

double
lengthOf(const std::vector<PlanarPose>& poses)
{
  return std::hypot(poses.back().x - poses.front().x, poses.back().z - poses.front().z);
}

/** Relative difference of the distances from the first to the last pose, percent. */
double
excess(const std::vector<PlanarPose>& poses, const std::vector<PlanarPose>& other)
{
  return 100 * (lengthOf(poses) / lengthOf(other) - 1);
}

void
printBows(const RectificationMap& map, const std::vector<CorridorRun>& runs)
{
  constexpr double max_degrees = 0.3;
  std::cout << "\nBow of the straight corridor: angle between the walls of the first "
               "and of the last third; in the true map "
            << bowOf(map, map.truth) << " degrees.\n";
  printHead({"map, seed",
             "bow before, degrees",
             "after",
             "after LUM",
             "length before, % too long",
             "after",
             "after LUM"});
  for (const CorridorRun& run : runs)
    MarkdownRow()
        .text(run.ours.name)
        .number(bowOf(map, run.ours.given), 2)
        .atMost(bowOf(map, run.ours.found), max_degrees, 2)
        .number(bowOf(map, run.lum_poses), 2)
        .number(excess(run.ours.given, map.truth), 2)
        .number(excess(run.ours.found, map.truth), 2)
        .number(excess(run.lum_poses, map.truth), 2)
        .print();
}

void
printBareCorridor()
{
  constexpr std::uint64_t seeds = 5;
  constexpr double max_percent = 1;
  std::cout << "\nA bare corridor: nothing tells where along it the camera is, and its "
               "length should stay as the odometry has it.\n";
  const RectificationMap map = makeSceneMap(bareCorridor());
  printHead({"map, seed",
             "error before, m",
             "after, m",
             "odometry's length, m",
             "after, % longer",
             "outcome",
             "CPU s"});
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const RectificationRun run =
        rectifyMap(map, drifted(map.truth, cameraDrift(), seed));
    MarkdownRow()
        .text(map.name + ", " + std::to_string(seed))
        .number(run.before.unaligned, 3)
        .number(run.after.unaligned, 3)
        .number(lengthOf(run.given), 2)
        .within(excess(run.found, run.given), max_percent, 2)
        .text(nameOf(run.report.outcome))
        .number(run.seconds, 1)
        .print();
  }
}

} // namespace

void
printCorridors()
{
  constexpr std::uint64_t seeds = 3;
  std::cout << "\n### Simulated corridors\n";
  printHead({"map, seed",
             "error before, m",
             "after, m",
             "ratio",
             "ratio, aligned",
             "outcome",
             "odometry's scale",
             "CPU s",
             "LUM, ratio",
             "CPU s",
             "ELCH, ratio",
             "CPU s"});
  const RectificationMap straight = makeSceneMap(standardScene("corridor"));
  const auto print = [&](const RectificationMap& map, bool is_loop) {
    std::vector<CorridorRun> runs;
    const ObservationPairs pairs = truePairs(map);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      runs.push_back(runCorridor(map, seed, pairs, is_loop));
      printCorridorRun(runs.back(), is_loop);
    }
    printMedians(map.name, runs, is_loop);
    return runs;
  };
  const std::vector<CorridorRun> straight_runs = print(straight, false);
  print(makeSceneMap(standardScene("l_corridor")), false);
  print(makeSceneMap(standardScene("loop")), true);
  printBows(straight, straight_runs);
  printBareCorridor();
}

} // namespace pcl::acmap::bench
