#include "plane_tables.h"
#include "units.h"

#include "markdown_row.h"
#include "plane_scores.h"

#include <cmath>
#include <iostream>
#include <limits>

namespace pcl::acmap::bench {
namespace {

/** Targets for acmap; every plane that counts should be found. */
struct PlaneReach {
  double spurious = no_reach;
  double angle = no_reach;  // degrees
  double offset = no_reach; // metres
  double labels = no_reach; // percent
  double seconds = no_reach;

  bool
  isGiven() const
  {
    return !std::isnan(seconds);
  }
};

struct ScoredFinder {
  std::string name;
  PlaneReach reach;
  PlaneScores scores;
};

std::string
textOf(const FoundShare& share, bool is_judged)
{
  const std::string text =
      std::to_string(share.found) + " of " + std::to_string(share.there);
  return is_judged && share.found < share.there ? "**" + text + "** (missed: all)"
                                                : text;
}

void
printFoundRow(const ScoredFinder& one)
{
  const PlaneScores& scores = one.scores;
  const bool is_judged = one.reach.isGiven();
  MarkdownRow()
      .text(one.name)
      .count(scores.given)
      .text(textOf(scores.main, is_judged))
      .text(textOf(scores.doors, is_judged))
      .text(textOf(scores.large, is_judged))
      .text(textOf(scores.all, false))
      .atMost(static_cast<double>(scores.spurious), one.reach.spurious, 0)
      .atMost(static_cast<double>(scores.duplicates), one.reach.spurious, 0)
      .atMost(scores.seconds, one.reach.seconds, 3)
      .print();
}

void
printFound(const std::vector<ScoredFinder>& all)
{
  printHead({"finder",
             "planes given",
             "main planes found",
             "doors",
             "planes with 0.3 % of the points",
             "all planes",
             "spurious",
             "duplicates",
             "CPU s"});
  for (const ScoredFinder& one : all)
    printFoundRow(one);
}

void
printAccuracyRow(const ScoredFinder& one)
{
  const PlaneScores& scores = one.scores;
  MarkdownRow()
      .text(one.name)
      .atMost(scores.main_errors.largest_angle, one.reach.angle, 3)
      .number(scores.main_errors.mean_angle, 3)
      .atMost(milli * scores.main_errors.largest_offset, milli * one.reach.offset, 2)
      .number(milli * scores.main_errors.mean_offset, 2)
      .number(scores.all_errors.largest_angle, 3)
      .number(scores.all_errors.mean_angle, 3)
      .number(milli * scores.all_errors.largest_offset, 2)
      .number(milli * scores.all_errors.mean_offset, 2)
      .atLeast(scores.large_labels, one.reach.labels, 2)
      .number(scores.all_labels, 2)
      .number(scores.precision, 2)
      .print();
}

void
printAccuracy(const std::vector<ScoredFinder>& all)
{
  printHead({"finder",
             "main planes: largest angle, degrees",
             "mean",
             "largest offset, mm",
             "mean",
             "all found: largest angle, degrees",
             "mean",
             "largest offset, mm",
             "mean",
             "labels right %",
             "of all points %",
             "of the labelled points %"});
  for (const ScoredFinder& one : all)
    printAccuracyRow(one);
}

void
printCase(const PlaneCase& plane_case,
          const NamedFinders& finders,
          const PlaneReach& reach)
{
  const PlaneInput& input = plane_case.input;
  std::cout << "\n### " << plane_case.name << "\n\n"
            << input.points->size() << " points; measured sigma " << 1000 * input.sigma
            << " mm, spacing " << 1000 * input.spacing << " mm; tolerance of the peers "
            << 1000 * input.tolerance << " mm\n";
  std::vector<ScoredFinder> all;
  for (const NamedFinder& finder : finders)
    if (input.points->size() <= finder.max_points)
      all.push_back({finder.name,
                     finder.is_ours ? reach : PlaneReach(),
                     scorePlanes(plane_case, findPlanes(finder, input))});
  if (all.empty()) {
    std::cout << "\nNo finder takes so many points.\n";
    return;
  }
  printFound(all);
  printAccuracy(all);
}

} // namespace

void
printViewPlanes(const SceneData& corridor, const NamedFinders& finders)
{
  printCase(makePlaneCase(makeViewCloud(corridor.scene(), 0)),
            finders,
            {0, 0.03, 0.0001, 99.5, 0.060});
}

void
printNoisyViewPlanes(const SceneData& corridor, const NamedFinders& finders)
{
  constexpr double disparity_noise = 0.5; // px
  SimulatedScene scene = corridor.scene();
  scene.sensor.noise_growth =
      disparity_noise /
      (scene.rig.focal_length * std::abs(scene.rig.baseline_horizontal));
  scene.sensor.min_noise = 0;
  scene.sensor.max_noise = std::numeric_limits<double>::max();
  PlaneCase plane_case = makePlaneCase(makeViewCloud(scene, 0));
  plane_case.name += ", disparities with a noise of 0.5 px";
  printCase(plane_case, finders, {});
}

void
printMillionPlanes(SceneData& corridor, const NamedFinders& finders)
{
  printCase(makePlaneCase(makeRandomPart(corridor.whole(), 1000000, 1)),
            finders,
            {0, 0.05, 0.0005, 99, 0.6});
}

void
printWholePlanes(SceneData& corridor, const NamedFinders& finders)
{
  printCase(makePlaneCase(corridor.whole()), finders, {0, 0.05, 0.0005, 99, 12});
}

} // namespace pcl::acmap::bench
