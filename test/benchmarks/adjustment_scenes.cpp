#include "adjustment_runs.h"
#include "adjustment_tables.h"
#include "markdown_row.h"
#include "rectification_maps.h"
#include "rectification_peers.h"
#include "statistics.h"
#include "units.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <iostream>
#include <map>

namespace pcl::acmap::bench {
namespace {

constexpr std::uint64_t noise_seed = 1;
constexpr double max_ratio = 0.05, max_worst = 0.1, max_height = 0.01; // metres

/** Runs of one scene and drift. */
struct RunSummary {
  std::vector<double> before, ratios, heights, seconds, chi2;
  std::size_t adjusted = 0, kept = 0, refused = 0, worse = 0;

  void
  add(const AdjustmentRun& run)
  {
    before.push_back(run.before);
    ratios.push_back(run.ratio());
    heights.push_back(run.height);
    seconds.push_back(run.seconds);
    adjusted += run.report.outcome == AdjustmentOutcome::Adjusted;
    kept += run.report.outcome == AdjustmentOutcome::Kept;
    refused += run.report.outcome == AdjustmentOutcome::Refused;
    worse += run.ratio() > 1;
  }
};

void
printRunHead()
{
  printHead({"scene",
             "drift",
             "runs",
             "ATE before, median, m",
             "ratio, median",
             "ratio, worst",
             "height, worst, mm",
             "adjusted, kept, refused",
             "worse than before",
             "CPU s, median"});
}

void
printRuns(const std::string& scene, const std::string& drift, const RunSummary& runs)
{
  MarkdownRow()
      .text(scene)
      .text(drift)
      .count(runs.ratios.size())
      .number(median(runs.before), 3)
      .atMost(median(runs.ratios), max_ratio, 3)
      .atMost(quantile(runs.ratios, 1), max_worst, 3)
      .atMost(milli * quantile(runs.heights, 1), milli * max_height, 1)
      .text(std::to_string(runs.adjusted) + ", " + std::to_string(runs.kept) + ", " +
            std::to_string(runs.refused))
      .atMost(static_cast<double>(runs.worse), 0, 0)
      .number(median(runs.seconds), 1)
      .print();
}

RunSummary
runAll(const AdjustmentScene& scene, const FreeDrift& drift, const DriftSeeds& seeds)
{
  RunSummary runs;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed)
    runs.add(adjust(scene, driftedFreely(scene.truth, drift, seed), drift));
  return runs;
}

const std::vector<std::string>&
adjustedScenes()
{
  static const std::vector<std::string> names = {
      "corridor", "corridor_survey", "l_corridor", "loop", "office"};
  return names;
}

} // namespace

void
printAdjustedScenes(const DriftSeeds& seeds)
{
  std::cout << "\n### Simulated scenes, drift in six degrees of freedom\n";
  printRunHead();
  for (const std::string& name : adjustedScenes()) {
    std::map<double, RunSummary> runs;
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      const AdjustmentScene scene = makeAdjustmentScene(standardScene(name), seed);
      for (const double level : {1.0, 4.0, 8.0}) {
        FreeDrift drift;
        drift.level = level;
        runs[level].add(adjust(scene, driftedFreely(scene.truth, drift, seed), drift));
      }
    }
    for (const auto& [level, summary] : runs)
      printRuns(name, std::to_string(static_cast<int>(level)) + " x", summary);
  }
}

void
printRectifiedScenes(const DriftSeeds& seeds)
{
  std::cout << "\n### After the rectification by entropy\n";
  printRunHead();
  for (const std::string& name : adjustedScenes()) {
    const SimulatedScene simulated = standardScene(name);
    const RectificationMap map = makeSceneMap(simulated);
    std::map<double, RunSummary> runs;
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      const AdjustmentScene scene = makeAdjustmentScene(simulated, seed);
      for (const double level : {4.0, 8.0}) {
        FreeDrift drift;
        drift.level = level;
        runs[level].add(rectifyAndAdjust(
            scene, map, driftedFreely(scene.truth, drift, seed), drift));
      }
    }
    for (const auto& [level, summary] : runs)
      printRuns(name, std::to_string(static_cast<int>(level)) + " x", summary);
  }
}

void
printAdjustmentPeers(const DriftSeeds& seeds)
{
  std::cout << "\n### The same drift, 1 x, by methods of PCL\n";
  printHead({"scene",
             "ratio, median",
             "LUM",
             "CPU s",
             "GICP chain, one seed",
             "CPU s",
             "ELCH",
             "CPU s"});
  for (const std::string& name : adjustedScenes()) {
    const SimulatedScene simulated = standardScene(name);
    const AdjustmentScene scene = makeAdjustmentScene(simulated, noise_seed);
    const RectificationMap map = makeSceneMap(simulated);
    const ObservationPairs pairs = truePairs(map);
    std::vector<double> ours, ratios[3], seconds[3];
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      const auto given = driftedFreely(scene.truth, FreeDrift(), seed);
      const double before = absoluteTrajectoryError(given, scene.truth).unaligned;
      ours.push_back(adjust(scene, given, FreeDrift()).ratio());
      const auto add = [&](int peer, const PeerRun& run) {
        ratios[peer].push_back(
            absoluteTrajectoryError(run.poses, scene.truth).unaligned / before);
        seconds[peer].push_back(run.seconds);
      };
      add(0, runLum(map.clouds, given, pairs));
      if (seed == seeds.first && name == adjustedScenes().front()) // it takes minutes
        add(1, runGicpChain(map.clouds, given));
      if (name == "loop")
        add(2, runElch(map.clouds, given));
    }
    MarkdownRow row;
    row.text(name).number(median(ours), 3);
    for (int peer = 0; peer < 3; ++peer)
      if (ratios[peer].empty())
        row.text("not run").text("");
      else
        row.number(median(ratios[peer]), 3).number(median(seconds[peer]), 1);
    row.print();
  }
}

void
printWrongOdometry(const DriftSeeds& seeds)
{
  std::cout << "\n### Odometry that errs otherwise than told\n";
  printRunHead();
  const std::vector<std::pair<std::string, FreeDrift>> kinds = {
      {"bias of 0.1 degrees", {1, 0.1, false, 1}},
      {"one action in ten 5 x", {1, 0, true, 1}},
      {"told 3 x too small", {1, 0, false, 1.0 / 3}},
      {"told 3 x too large", {1, 0, false, 3}},
      {"told 5 x too large", {1, 0, false, 5}}};
  for (const char* name : {"corridor_survey", "l_corridor"}) {
    const AdjustmentScene scene = makeAdjustmentScene(standardScene(name), noise_seed);
    for (const auto& [kind, drift] : kinds)
      printRuns(name, kind, runAll(scene, drift, seeds));
  }
}

void
printRightPoses()
{
  constexpr double max_move = 3; // millimetres
  std::cout << "\n### Poses that are right already\n";
  printHead({"scene", "outcome", "significance", "farthest move, mm"});
  for (const std::string& name : adjustedScenes()) {
    const AdjustmentScene scene = makeAdjustmentScene(standardScene(name), noise_seed);
    const AdjustmentRun run = adjust(scene, scene.truth, FreeDrift());
    MarkdownRow()
        .text(name)
        .text(nameOf(run.report.outcome))
        .number(run.report.significance, 1)
        .atMost(milli * quantile(run.report.moved, 1), max_move, 1)
        .print();
  }
}

void
printBlankCorridor(const DriftSeeds& seeds)
{
  constexpr double max_percent = 0.1;
  std::cout << "\n### A corridor without features\n";
  printHead(
      {"seed", "told", "length before, % too long", "after", "change", "outcome"});
  const AdjustmentScene scene = makeAdjustmentScene(bareCorridor(), noise_seed);
  for (const double told : {1.0, 3.0})
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      FreeDrift drift;
      drift.told = told;
      const AdjustmentRun run =
          adjust(scene, driftedFreely(scene.truth, drift, seed), drift);
      MarkdownRow()
          .count(seed)
          .number(told, 0)
          .number(run.length_before, 3)
          .number(run.length_after, 3)
          .within(run.length_after - run.length_before, max_percent, 3)
          .text(nameOf(run.report.outcome))
          .print();
    }
}

void
printAdjustmentSize()
{
  constexpr double max_seconds = 4;
  std::cout << "\n### Time\n";
  printHead(
      {"views", "pieces", "planes", "rounds", "ratio", "cut, s", "adjust, s", "CPU s"});
  SimulatedScene scene = standardScene("corridor");
  const AdjustmentScene short_scene = makeAdjustmentScene(scene, noise_seed);
  AdjustmentScene long_scene;
  // The same corridor, ten times in a row.
  constexpr std::size_t times = 10;
  const std::size_t views = short_scene.clouds.size();
  const Eigen::Vector3d along =
      short_scene.truth[views - 1].translation() - short_scene.truth[5].translation();
  for (std::size_t part = 0; part < times; ++part)
    for (std::size_t i = part == 0 ? 0 : 6; i < views; ++i) {
      Eigen::Isometry3d pose = short_scene.truth[i];
      pose.translation() += static_cast<double>(part) * along;
      long_scene.truth.push_back(pose);
      long_scene.clouds.push_back(short_scene.clouds[i]);
    }
  const auto print = [&](const AdjustmentScene& measured, double reach) {
    const AdjustmentRun run =
        adjust(measured, driftedFreely(measured.truth, FreeDrift(), 1), FreeDrift());
    MarkdownRow()
        .count(measured.clouds.size())
        .count(run.report.pieces)
        .count(run.report.landmarks)
        .count(run.report.rounds.size())
        .number(run.ratio(), 3)
        .number(run.report.seconds[0].second, 1)
        .number(run.report.seconds[1].second, 1)
        .atMost(run.seconds, reach, 1)
        .print();
  };
  print(short_scene, max_seconds);
  print(long_scene, no_reach);
}

} // namespace pcl::acmap::bench
