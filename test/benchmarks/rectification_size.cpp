#include "rectification_tables.h"

#include "markdown_row.h"
#include "peak_memory.h"
#include "rectification_runs.h"

#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

void
printUnmoved(const RectificationMap& map)
{
  const RectificationRun run = rectifyMap(map, map.truth);
  const std::vector<double>& moved = run.report.moved;
  MarkdownRow()
      .text(map.name)
      .text(nameOf(run.report.outcome))
      .atMost(*std::max_element(moved.begin(), moved.end()), map.bin_size / 2, 3)
      .number(run.after.unaligned, 3)
      .number(run.after.aligned, 3)
      .number(run.report.odometry_scale, 0)
      .number(run.seconds, 1)
      .print();
}

std::size_t
pointsOf(const RectificationMap& map)
{
  std::size_t points = 0;
  for (const auto& cloud : map.clouds)
    points += cloud->size();
  return points;
}

} // namespace

void
printPerfect()
{
  std::cout << "\n### Maps that are right already\n";
  printHead({"map",
             "outcome",
             "farthest move, m",
             "moved, rms, m",
             "after alignment",
             "odometry's scale",
             "CPU s"});
  for (const RectificationMap& map : makeLogMaps())
    printUnmoved(map);
  for (const char* scene : {"corridor", "l_corridor", "loop"})
    printUnmoved(makeSceneMap(standardScene(scene)));
}

void
printSize()
{
  constexpr double max_seconds = 30;
  constexpr double mebi = 1024 * 1024;
  std::cout << "\n### The paper's size\n";
  const PeakMemory memory;
  const SimulatedScene scene = standardScene("corridor");
  const RectificationMap map = makeSceneMap(scene);
  const RectificationRun run = rectifyMap(map, drifted(map.truth, cameraDrift(), 1));
  const double peak = static_cast<double>(memory.bytes()) / mebi;
  std::size_t points = 0;
  for (std::size_t view = 0; view < scene.views.size(); ++view)
    points += scene.sensor.pointsOfView(view);
  printHead({"observations",
             "points",
             "consolidated",
             "consolidation, CPU s",
             "rectification, CPU s",
             "sum, CPU s",
             "peak memory, MiB",
             "outcome",
             "ratio"});
  MarkdownRow()
      .count(scene.views.size())
      .count(points)
      .count(pointsOf(map))
      .number(map.consolidation_seconds, 1)
      .number(run.seconds, 1)
      .atMost(map.consolidation_seconds + run.seconds, max_seconds, 1)
      .number(peak, 0)
      .text(nameOf(run.report.outcome))
      .number(run.ratio(), 3)
      .print();
}

} // namespace pcl::acmap::bench
