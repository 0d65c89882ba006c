#include "adjustment_runs.h"
#include "bench.h"
#include "bench_data.h"
#include "rectification_peers.h"
#include "rectification_runs.h"

#include <pcl/conversions.h>
#include <pcl/core/pinhole.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/egomotion/revisit_detection.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/rgbd_sequence.h>
#include <pcl/simulation/standard_scenes.h>

#include <functional>
#include <map>

namespace pcl::acmap::bench {
namespace {

constexpr std::uint64_t noise_seed = 1;
constexpr double max_ratio = 0.05, max_worst = 0.1, max_height = 0.01; // metres

/** Runs of one scene and drift. */
struct RunSummary {
  std::vector<double> before, ratios, heights, seconds;
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
  printHead("scene | drift | runs | ATE before, median, m | ratio, median | ratio, "
            "worst | height, worst, mm | adjusted, kept, refused | worse than before | "
            "CPU s, median");
}

void
printRuns(const std::string& scene, const std::string& drift, const RunSummary& runs)
{
  Row() << scene << drift << runs.ratios.size() << figure(median(runs.before), 3)
        << atMost(median(runs.ratios), max_ratio, 3)
        << atMost(largest(runs.ratios), max_worst, 3)
        << atMost(milli * largest(runs.heights), milli * max_height, 1)
        << std::to_string(runs.adjusted) + ", " + std::to_string(runs.kept) + ", " +
               std::to_string(runs.refused)
        << atMost(runs.worse, 0, 0) << figure(median(runs.seconds), 1);
}

RunSummary
runAll(const AdjustmentScene& scene, const FreeDrift& drift)
{
  RunSummary runs;
  for (const std::uint64_t seed : driftSeeds())
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

using AdjustOne =
    std::function<AdjustmentRun(const AdjustmentScene& scene,
                                const std::vector<Eigen::Isometry3d>& given,
                                const FreeDrift& drift)>;

/** Runs of a scene under several levels of drift, with a noise of its own for each
 * seed. */
void
printLevels(const SimulatedScene& simulated,
            const std::vector<double>& levels,
            const AdjustOne& adjustOne)
{
  std::map<double, RunSummary> runs;
  for (const std::uint64_t seed : driftSeeds()) {
    const AdjustmentScene scene = makeAdjustmentScene(simulated, seed);
    for (const double level : levels) {
      FreeDrift drift;
      drift.level = level;
      runs[level].add(adjustOne(scene, driftedFreely(scene.truth, drift, seed), drift));
    }
  }
  for (const auto& [level, summary] : runs)
    printRuns(simulated.name, std::to_string(static_cast<int>(level)) + " x", summary);
}

const Section scenes_section("scenes", [] {
  printRunHead();
  for (const std::string& name : adjustedScenes())
    printLevels(standardScene(name),
                {1, 4, 8},
                [](const auto& scene, const auto& given, const auto& drift) {
                  return adjust(scene, given, drift);
                });
});

const Section entropy_section("entropy", [] {
  printRunHead();
  for (const std::string& name : adjustedScenes()) {
    const SimulatedScene simulated = standardScene(name);
    const RectificationMap map = makeSceneMap(simulated);
    printLevels(simulated,
                {4, 8},
                [&map](const auto& scene, const auto& given, const auto& drift) {
                  return rectifyAndAdjust(scene, map, given, drift);
                });
  }
});

const Section peers_section("peers", [] {
  printHead("scene | ratio, median | LUM | CPU s | ELCH | CPU s");
  for (const std::string& name : adjustedScenes()) {
    const SimulatedScene simulated = standardScene(name);
    const AdjustmentScene scene = makeAdjustmentScene(simulated, noise_seed);
    const RectificationMap map = makeSceneMap(simulated);
    const ObservationPairs pairs = truePairs(map);
    std::vector<double> ours, ratios[2], seconds[2];
    for (const std::uint64_t seed : driftSeeds()) {
      const auto given = driftedFreely(scene.truth, FreeDrift(), seed);
      const double before = absoluteTrajectoryError(given, scene.truth).unaligned;
      ours.push_back(adjust(scene, given, FreeDrift()).ratio());
      const auto add = [&](int peer, const PeerRun& run) {
        ratios[peer].push_back(
            absoluteTrajectoryError(run.poses, scene.truth).unaligned / before);
        seconds[peer].push_back(run.seconds);
      };
      add(0, runLum(map.clouds, given, pairs));
      if (name == "loop")
        add(1, runElch(map.clouds, given));
    }
    Row row;
    row << name << figure(median(ours), 3);
    for (int peer = 0; peer < 2; ++peer)
      if (ratios[peer].empty())
        row << "not run"
            << "";
      else
        row << figure(median(ratios[peer]), 3) << figure(median(seconds[peer]), 1);
  }
});

const Section odometry_section("odometry", [] {
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
      printRuns(name, kind, runAll(scene, drift));
  }
});

const Section perfect_section("perfect", [] {
  constexpr double max_move = 3; // millimetres
  printHead("scene | outcome | significance | farthest move, mm");
  for (const std::string& name : adjustedScenes()) {
    const AdjustmentScene scene = makeAdjustmentScene(standardScene(name), noise_seed);
    const AdjustmentRun run = adjust(scene, scene.truth, FreeDrift());
    Row() << name << nameOf(run.report.outcome) << figure(run.report.significance, 1)
          << atMost(milli * largest(run.report.moved), max_move, 1);
  }
});

const Section blank_section("blank", [] {
  constexpr double max_percent = 0.1;
  printHead("seed | told | length before, % too long | after | change | outcome");
  const AdjustmentScene scene = makeAdjustmentScene(bareCorridor(), noise_seed);
  for (const double told : {1.0, 3.0})
    for (const std::uint64_t seed : driftSeeds()) {
      FreeDrift drift;
      drift.told = told;
      const AdjustmentRun run =
          adjust(scene, driftedFreely(scene.truth, drift, seed), drift);
      Row() << seed << figure(told, 0) << figure(run.length_before, 3)
            << figure(run.length_after, 3)
            << within(run.length_after - run.length_before, max_percent, 3)
            << nameOf(run.report.outcome);
    }
});

using View = PointCloud<PointXYZRGBSigma>;

constexpr std::size_t min_separation = 10; // views

/** The share of the points of a view that another one saw at the same place. */
double
seenShare(const View& view,
          const View& other,
          const Pinhole& pinhole,
          const Eigen::Isometry3d& T_other_view)
{
  constexpr std::size_t every = 16; // pixels
  constexpr double tolerance = 0.05;
  std::size_t points = 0, seen = 0;
  for (std::size_t row = 0; row < view.height; row += every)
    for (std::size_t column = 0; column < view.width; column += every) {
      const auto& point = view.at(static_cast<int>(column), static_cast<int>(row));
      if (!std::isfinite(point.z))
        continue;
      ++points;
      const Eigen::Vector3d there =
          T_other_view * point.getVector3fMap().cast<double>();
      if (there.z() <= 0)
        continue;
      const Eigen::Vector2d pixel = pinhole.project(there);
      const int x = static_cast<int>(std::lround(pixel.x()));
      const int y = static_cast<int>(std::lround(pixel.y()));
      if (x < 0 || y < 0 || x >= static_cast<int>(other.width) ||
          y >= static_cast<int>(other.height))
        continue;
      seen += std::abs(other.at(x, y).z - there.z()) < tolerance * there.z();
    }
  return points > 0 ? static_cast<double>(seen) / static_cast<double>(points) : 0;
}

/** Scores of revisits against true poses. */
struct RevisitScores {
  std::size_t found = 0, right = 0;
  std::size_t places = 0;   ///< views that see a place of a view far before or after
  std::size_t answered = 0; ///< of these, those with a right revisit
  double shift = 0;         ///< metres, median error
  double turn = 0;          ///< degrees, median error
};

RevisitScores
scoresOf(const std::vector<View::Ptr>& clouds,
         const std::vector<Eigen::Isometry3d>& truth,
         const std::vector<Revisit>& revisits)
{
  constexpr double max_shift = 0.1, max_turn = 3; // metres, degrees
  constexpr double same_place = 0.3;
  RevisitScores scores;
  std::vector<char> is_place(clouds.size()), is_answered(clouds.size());
  std::vector<double> shifts, turns;
  for (const Revisit& revisit : revisits) {
    const Eigen::Isometry3d error = revisit.estimate.T_target_source.inverse() *
                                    truth[revisit.earlier].inverse() *
                                    truth[revisit.later];
    shifts.push_back(error.translation().norm());
    turns.push_back(Eigen::AngleAxisd(error.linear()).angle() / degree);
    const bool is_right = shifts.back() < max_shift && turns.back() < max_turn;
    ++scores.found;
    scores.right += is_right;
    if (is_right)
      is_answered[revisit.earlier] = is_answered[revisit.later] = 1;
  }
  for (std::size_t a = 0; a < clouds.size(); ++a) {
    const auto pinhole =
        fitPinhole({&clouds[a]->front().x, sizeof(PointXYZRGBSigma), clouds[a]->size()},
                   clouds[a]->width);
    for (std::size_t b = a + min_separation; pinhole && b < clouds.size(); ++b) {
      const Eigen::Isometry3d T_a_b = truth[a].inverse() * truth[b];
      if (seenShare(*clouds[b], *clouds[a], *pinhole, T_a_b) > same_place &&
          seenShare(*clouds[a], *clouds[b], *pinhole, T_a_b.inverse()) > same_place)
        is_place[a] = is_place[b] = 1;
    }
  }
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    scores.places += is_place[i];
    scores.answered += is_place[i] && is_answered[i];
  }
  if (!shifts.empty()) {
    scores.shift = median(shifts);
    scores.turn = median(turns);
  }
  return scores;
}

struct RevisitRun {
  std::vector<Revisit> revisits;
  RevisitReport report;
  double seconds = 0; ///< CPU, one thread
};

RevisitRun
detect(const std::vector<View::Ptr>& clouds)
{
  RevisitDetection<PointXYZRGBSigma> detection;
  detection.setNumberOfThreads(1);
  detection.setMinimumSeparation(min_separation);
  for (const View::Ptr& cloud : clouds)
    detection.addPointCloud(cloud);
  RevisitRun run;
  run.seconds = measureCost([&] { detection.compute(); }).cpu;
  run.revisits = detection.getRevisits();
  run.report = detection.getReport();
  return run;
}

void
printScores(const std::string& name, const RevisitRun& run, const RevisitScores& scores)
{
  Row row;
  row << name << run.report.views << run.report.keypoints << run.report.proposals
      << run.report.consistent << run.report.verified;
  if (scores.found > 0)
    row << atLeast(
        static_cast<double>(scores.right) / static_cast<double>(scores.found), 1, 3);
  else
    row << "no revisit";
  row << scores.places << scores.answered << figure(milli * scores.shift, 1)
      << figure(scores.turn, 2) << figure(run.seconds, 1);
}

void
printKitchenScores()
{
  const auto folder = pathOfKitchen();
  if (!folder)
    return;
  const RgbdSequence recorded = openRgbdSequence(*folder);
  const ObservationSequence sequence(recorded, recorded.cameras());
  std::vector<View::Ptr> clouds;
  std::vector<Eigen::Isometry3d> given;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const PosedObservation seen = sequence.load(i);
    const auto cloud = std::make_shared<View>();
    fromPCLPointCloud2(seen.file->cloud, *cloud);
    clouds.push_back(cloud);
    given.push_back(seen.T_map_camera);
  }
  const RevisitRun run = detect(clouds);
  printScores("red kitchen", run, scoresOf(clouds, given, run.revisits));
}

/** Adjustments of one scene and drift, with and without revisits. */
void
printAdjusted(const AdjustmentScene& scene,
              double level,
              const std::vector<Revisit>& revisits)
{
  FreeDrift drift;
  drift.level = level;
  std::vector<double> before, ratios[2], used, dropped;
  for (const std::uint64_t seed : driftSeeds()) {
    const auto given = driftedFreely(scene.truth, drift, seed);
    const AdjustmentRun without = adjust(scene, given, drift);
    const AdjustmentRun with = adjust(scene, given, drift, revisits);
    before.push_back(with.before);
    ratios[0].push_back(without.ratio());
    ratios[1].push_back(with.ratio());
    used.push_back(static_cast<double>(with.report.revisits_used));
    dropped.push_back(static_cast<double>(with.report.revisits_dropped));
  }
  Row row;
  row << scene.name << std::to_string(static_cast<int>(level)) + " x" << before.size()
      << figure(median(before), 3);
  for (const std::vector<double>& ratio : ratios)
    row << figure(median(ratio), 3) << figure(quantile(ratio, 1), 3);
  row << figure(median(used), 0) << figure(median(dropped), 0);
}

const Section revisits_section("revisits", [] {
  printHead("views of | views | keypoints | proposed | consistent | verified | "
            "precision | views that see a place again | of these with a revisit | "
            "error, median, mm | degrees | CPU s");
  printKitchenScores();
  std::vector<AdjustmentScene> scenes;
  std::vector<RevisitRun> runs;
  for (const char* name : {"loop", "corridor_survey", "office"}) {
    scenes.push_back(makeAdjustmentScene(standardScene(name), 1));
    const AdjustmentScene& scene = scenes.back();
    runs.push_back(detect(scene.clouds));
    printScores(
        name, runs.back(), scoresOf(scene.clouds, scene.truth, runs.back().revisits));
  }
  printHead("scene | drift | runs | ATE before, median, m | ratio without, median | "
            "worst | ratio with, median | worst | used, median | dropped, median");
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (const double level : {4.0, 8.0})
      printAdjusted(scenes[i], level, runs[i].revisits);
});

} // namespace
} // namespace pcl::acmap::bench
