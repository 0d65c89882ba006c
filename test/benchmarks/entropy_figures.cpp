#include "entropy_maps.h"
#include "entropy_pass.h"
#include "markdown_row.h"
#include "sections.h"
#include "timing.h"
#include "units.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr char usage[] =
    "Usage: acmap_bench_entropy_figures [paper] [laser]\n"
    "Prints what the entropy of a map takes, beside one plain pass over its points, "
    "and\n"
    "how far the fast one is off the exact one, as Markdown tables.\n";

std::vector<EntropyCells>
aggregateAll(const std::vector<PosedPoints>& observations,
             const MapEntropySettings& settings)
{
  std::vector<EntropyCells> cells;
  for (const PosedPoints& one : observations)
    cells.push_back(aggregateCells(one.points, one.normals, settings, one.weights));
  return cells;
}

/** CPU seconds, one thread, medians of interleaved rounds; slow ones get fewer
 * rounds. */
struct EntropyCosts {
  double pass = 0, histogram = 0, cells = 0, entropy = 0, gradient = 0, exact = 0;
  double difference = 0; ///< bits, fast - exact
  MapEntropyReport report;
};

EntropyCosts
measure(const EntropyMap& map, const MapEntropySettings& settings)
{
  constexpr std::size_t rounds = 25, slow_rounds = 5;
  const std::vector<PosedPoints> observations = map.observations();
  EntropyPass plain(map, settings.bin_size);
  std::vector<double> pass, histogram, cells, entropy, gradient, exact;
  EntropyCosts costs;
  double fast_bits = 0, exact_bits = 0;
  std::int64_t sum = 0;
  std::vector<EntropyCells> aggregated;
  for (std::size_t round = 0; round < slow_rounds; ++round) {
    cells.push_back(
        measureThread([&] { aggregated = aggregateAll(observations, settings); }));
    MapEntropyReport report;
    exact.push_back(measureThread([&] {
      exact_bits = exactMapEntropy(observations, settings, Progress(), report).total;
    }));
  }
  MapEntropyEvaluator evaluator(aggregated, settings);
  std::vector<Eigen::Vector3d> slopes;
  for (std::size_t round = 0; round < rounds; ++round) {
    costs.report = {};
    pass.push_back(measureThread([&] { sum += plain.find(); }));
    histogram.push_back(measureThread([&] { sum += plain.count(); }));
    entropy.push_back(measureThread(
        [&] { fast_bits = evaluator.evaluate(map.poses, costs.report).total; }));
    costs.report = {};
    gradient.push_back(
        measureThread([&] { evaluator.evaluate(map.poses, costs.report, &slopes); }));
  }
  if (sum == 1)
    std::cerr << "a rare sum\n"; // prevents the compiler from removing the pass
  costs.pass = median(pass);
  costs.histogram = median(histogram);
  costs.cells = median(cells);
  costs.entropy = median(entropy);
  costs.gradient = median(gradient);
  costs.exact = median(exact);
  costs.difference = fast_bits - exact_bits;
  return costs;
}

/** Targets for a map; \ref no_reach if there is no target. */
struct EntropyReach {
  double entropy_ms, passes, gradient_times, gradient_ms, cells;
};

void
printRow(const EntropyMap& map,
         double bin_size,
         bool direction_aware,
         const EntropyReach& reach)
{
  MapEntropySettings settings;
  settings.bin_size = settings.smoothing = bin_size;
  settings.direction_aware = direction_aware;
  EntropyCosts costs;
  withThreads(1, [&] { costs = measure(map, settings); });
  MarkdownRow()
      .text(map.name + (direction_aware ? ", 9 layers" : ""))
      .count(map.size())
      .count(costs.report.cells)
      .count(costs.report.bins_x * costs.report.bins_z * costs.report.layers)
      .number(milli * costs.pass, 2)
      .number(milli * costs.histogram, 2)
      .atMost(costs.cells, reach.cells, 2)
      .atMost(milli * costs.entropy, reach.entropy_ms, 2)
      .atMost(costs.entropy / costs.pass, reach.passes, 2)
      .atMost(milli * costs.gradient, reach.gradient_ms, 2)
      .atMost(costs.gradient / costs.entropy, reach.gradient_times, 2)
      .number(milli * costs.exact, 0)
      .number(costs.difference, 4)
      .print();
}

} // namespace
} // namespace pcl::acmap::bench

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  Sections sections;
  if (const auto exit_code =
          Sections::read(argc, argv, {"paper", "laser"}, usage, sections))
    return *exit_code;
  printHead({"map",
             "points",
             "cells",
             "bins",
             "finding bins, ms",
             "histogram, ms",
             "making cells, s",
             "entropy, ms",
             "of finding bins",
             "with gradient, ms",
             "times the entropy",
             "exact, ms",
             "fast - exact, bits"});
  if (sections.isWanted("paper")) {
    const EntropyMap map = makePaperMap();
    printRow(map, 0.05, false, {4, 0.2, 2.5, no_reach, 0.5});
    printRow(map, 0.05, true, {no_reach, no_reach, no_reach, no_reach, 0.5});
  }
  if (sections.isWanted("laser")) {
    const EntropyMap map = makeLaserMap();
    printRow(map, 0.1, false, {no_reach, no_reach, no_reach, no_reach, no_reach});
    printRow(map, 0.1, true, {no_reach, no_reach, no_reach, 4, no_reach});
  }
  return 0;
}
