#include "rectification_tables.h"

#include "markdown_row.h"
#include "rectification_runs.h"
#include "statistics.h"

#include <algorithm>
#include <iostream>
#include <sstream>

namespace pcl::acmap::bench {
namespace {

constexpr std::uint64_t seeds = 3;
constexpr double failure = 0.5; ///< ratio above which the rectification of a map failed

using Maps = std::vector<RectificationMap>;
using Runs = std::vector<RectificationRun>;
using Configure = std::function<void(Rectification&)>;

double
contradicted(const MapEvidence& evidence)
{
  return evidence.near_contradictions + evidence.far_contradictions;
}

void
printRunsHead()
{
  printHead({"map, drift, seed",
             "error before, m",
             "after, m",
             "ratio",
             "ratio, aligned",
             "rays contradicted before",
             "after",
             "odometry's scale",
             "outcome",
             "CPU s"});
}

void
printRun(const RectificationRun& run)
{
  MarkdownRow()
      .text(run.name)
      .number(run.before.unaligned, 3)
      .number(run.after.unaligned, 3)
      .number(run.ratio(), 3)
      .number(run.alignedRatio(), 3)
      .number(contradicted(run.report.before), 3)
      .number(contradicted(run.report.after), 3)
      .number(run.report.odometry_scale, 0)
      .text(nameOf(run.report.outcome))
      .number(run.seconds, 1)
      .print();
}

/** Runs each map with each seed and prints the results one by one; the remark becomes
 * part of their names. */
Runs
runAll(const Maps& maps,
       double level,
       std::uint64_t last_seed,
       const Configure& configure = {},
       const std::string& remark = "")
{
  Runs runs;
  for (const RectificationMap& map : maps)
    for (std::uint64_t seed = 1; seed <= last_seed; ++seed) {
      runs.push_back(
          rectifyMap(map, drifted(map.truth, robotDrift(level), seed), configure));
      std::ostringstream name;
      name << map.name << remark << ", x " << level << ", " << seed;
      runs.back().name = name.str();
      printRun(runs.back());
    }
  return runs;
}

std::vector<double>
valuesOf(const Runs& runs, const std::function<double(const RectificationRun&)>& value)
{
  std::vector<double> values;
  for (const RectificationRun& run : runs)
    values.push_back(value(run));
  return values;
}

double
largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
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
            << (run.report.outcome == RectificationOutcome::Refused ? ", refused)"
                                                                    : ")");
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

/** Runs that are summarized in one row. */
struct RunGroup {
  std::string name;
  Runs runs;
  RunsReach reach;
};

void
printGroup(const RunGroup& group)
{
  const Runs& runs = group.runs;
  if (runs.empty())
    return;
  const auto ratios =
      valuesOf(runs, [](const RectificationRun& run) { return run.ratio(); });
  const auto aligned =
      valuesOf(runs, [](const RectificationRun& run) { return run.alignedRatio(); });
  const auto seconds =
      valuesOf(runs, [](const RectificationRun& run) { return run.seconds; });
  const auto refused =
      std::count_if(runs.begin(), runs.end(), [](const RectificationRun& run) {
        return run.report.outcome == RectificationOutcome::Refused;
      });
  MarkdownRow()
      .text(group.name)
      .count(runs.size())
      .atMost(median(ratios), group.reach.median, 3)
      .number(largest(ratios), 3)
      .atMost(static_cast<double>(countAbove(runs, failure)), group.reach.failures, 0)
      .atMost(static_cast<double>(countAbove(runs, 1)), group.reach.worse, 0)
      .number(static_cast<double>(refused), 0)
      .number(median(aligned), 3)
      .number(largest(aligned), 3)
      .number(median(seconds), 1)
      .atMost(largest(seconds), group.reach.seconds, 1)
      .text(namesAbove(runs, failure))
      .print();
}

void
printGroups(const std::vector<RunGroup>& groups)
{
  printHead({"maps, drift",
             "runs",
             "ratio, median",
             "worst",
             "above 0.5",
             "worse than before",
             "refused",
             "ratio, aligned, median",
             "worst",
             "CPU s, median",
             "most",
             "those above 0.5"});
  for (const RunGroup& group : groups)
    printGroup(group);
}

std::string
groupName(const char* maps, double level)
{
  std::ostringstream name;
  name << maps << ", x " << level;
  return name.str();
}

void
printLogRuns(const Configure& configure, bool has_reach)
{
  const Maps logs = makeLogMaps(), long_logs = makeLongLogMaps();
  printRunsHead();
  constexpr double none = 0, seconds = 15;
  std::vector<RunGroup> groups;
  const auto add =
      [&](const char* name, const Maps& maps, double level, double maximum) {
        groups.push_back(
            {groupName(name, level),
             runAll(maps, level, seeds, configure),
             has_reach ? RunsReach{maximum, none, no_reach, seconds} : RunsReach{}});
      };
  add("logs", logs, 0.5, 0.15);
  add("logs", logs, 1, 0.1);
  add("logs", logs, 2, 0.1);
  for (const double level : {0.5, 1.0, 2.0})
    add("infinite-corridor", long_logs, level, 0.2);
  printGroups(groups);
}

} // namespace

void
printLogs()
{
  std::cout << "\n### Laser logs\n";
  printLogRuns({}, true);
}

void
printStrongDrift()
{
  std::cout << "\n### Laser logs, strong drift\n";
  constexpr double level = 4;
  RunsReach reach;
  reach.worse = 0;
  printRunsHead();
  const Runs runs = runAll(makeLogMaps(), level, seeds);
  const Runs long_runs = runAll(makeLongLogMaps(), level, seeds);
  printGroups({{groupName("logs", level), runs, reach},
               {groupName("infinite-corridor", level), long_runs, reach}});
}

void
printConstants()
{
  std::cout << "\n### Laser logs, other constants\n";
  struct Variant {
    std::string name;
    double entropy_weight, odometry_noise; ///< factors of the default values
  };
  const Maps logs = makeLogMaps();
  printRunsHead();
  std::vector<RunGroup> groups;
  for (const Variant& variant : {Variant{"as they are", 1, 1},
                                 Variant{"entropy's weight x 0.5", 0.5, 1},
                                 Variant{"entropy's weight x 2", 2, 1},
                                 Variant{"odometry's noise x 0.5", 1, 0.5},
                                 Variant{"odometry's noise x 2", 1, 2}})
    for (const double level : {1.0, 2.0}) {
      const auto configure = [&](Rectification& rectification) {
        const double times = variant.odometry_noise;
        const OdometryNoise usual;
        rectification.setEntropyWeight(variant.entropy_weight);
        rectification.setOdometryNoise({times * usual.length,
                                        times * usual.length_per_metre,
                                        times * usual.turn,
                                        times * usual.turn_per_radian});
      };
      groups.push_back({groupName(variant.name.c_str(), level),
                        runAll(logs, level, 1, configure, ", " + variant.name),
                        {}});
    }
  printGroups(groups);
}

void
printPaperMode()
{
  std::cout << "\n### Laser logs, the paper's search\n";
  printLogRuns(
      [](Rectification& rectification) {
        rectification.setMode(RectificationMode::Paper);
      },
      false);
}

} // namespace pcl::acmap::bench
