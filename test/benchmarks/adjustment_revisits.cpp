#include "adjustment_runs.h"
#include "adjustment_tables.h"
#include "markdown_row.h"
#include "statistics.h"
#include "test_data.h"
#include "timing.h"
#include "units.h"

#include <pcl/conversions.h>
#include <pcl/core/pinhole.h>
#include <pcl/egomotion/revisit_detection.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/rgbd_sequence.h>
#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

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
  MarkdownRow row;
  row.text(name)
      .count(run.report.views)
      .count(run.report.keypoints)
      .count(run.report.proposals)
      .count(run.report.consistent)
      .count(run.report.verified);
  if (scores.found > 0)
    row.atLeast(
        static_cast<double>(scores.right) / static_cast<double>(scores.found), 1, 3);
  else
    row.text("no revisit");
  row.count(scores.places)
      .count(scores.answered)
      .number(milli * scores.shift, 1)
      .number(scores.turn, 2)
      .number(run.seconds, 1)
      .print();
}

void
printKitchenScores()
{
  const std::string folder = "C_sequence/redkitchen_000_495";
  if (!test::hasTestData(folder + "/frame-000000.pose.txt"))
    return;
  const RgbdSequence recorded = openRgbdSequence(test::testDataPath(folder).string());
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
              const std::vector<Revisit>& revisits,
              const DriftSeeds& seeds)
{
  FreeDrift drift;
  drift.level = level;
  std::vector<double> before, ratios[2], used, dropped;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    const auto given = driftedFreely(scene.truth, drift, seed);
    const AdjustmentRun without = adjust(scene, given, drift);
    const AdjustmentRun with = adjust(scene, given, drift, revisits);
    before.push_back(with.before);
    ratios[0].push_back(without.ratio());
    ratios[1].push_back(with.ratio());
    used.push_back(static_cast<double>(with.report.revisits_used));
    dropped.push_back(static_cast<double>(with.report.revisits_dropped));
  }
  MarkdownRow row;
  row.text(scene.name)
      .text(std::to_string(static_cast<int>(level)) + " x")
      .count(before.size())
      .number(median(before), 3);
  for (const std::vector<double>& ratio : ratios)
    row.number(median(ratio), 3).number(quantile(ratio, 1), 3);
  row.number(median(used), 0).number(median(dropped), 0).print();
}

} // namespace

void
printRevisits(const DriftSeeds& seeds)
{
  std::cout << "\n### Revisits by appearance\n";
  printHead({"views of",
             "views",
             "keypoints",
             "proposed",
             "consistent",
             "verified",
             "precision",
             "views that see a place again",
             "of these with a revisit",
             "error, median, mm",
             "degrees",
             "CPU s"});
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
  std::cout << "\n### Adjustment with and without them\n";
  printHead({"scene",
             "drift",
             "runs",
             "ATE before, median, m",
             "ratio without, median",
             "worst",
             "ratio with, median",
             "worst",
             "used, median",
             "dropped, median"});
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (const double level : {4.0, 8.0})
      printAdjusted(scenes[i], level, runs[i].revisits, seeds);
}

} // namespace pcl::acmap::bench
