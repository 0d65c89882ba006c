#include "mesh_speed_tables.h"

#include "child_process.h"
#include "markdown_row.h"
#include "peak_memory.h"
#include "raw_mesh.h"
#include "statistics.h"
#include "timing.h"

#include <pcl/simulation/standard_scenes.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

struct MapRun {
  std::size_t points = 0, triangles = 0, used_points = 0;
  double seconds = 0;
  std::size_t peak = 0; // bytes in addition to the input
};

MapRun
meshMap(const std::string& standard_scene, DeWallRule rule)
{
  const SimulatedCloud cloud = makeSceneCloud(standardScene(standard_scene));
  MapRun run;
  const PeakMemory memory;
  run.seconds = measureThread([&] {
    const RawMesh raw = meshRaw(cloud.points(), rule);
    run.triangles = raw.report.triangles;
    run.used_points = raw.report.used_points;
  });
  run.peak = memory.bytes();
  run.points = cloud.size();
  return run;
}

void
printRow(DeWallRule rule, const MapRun& run)
{
  const auto points = static_cast<double>(run.points);
  const auto peak = static_cast<double>(run.peak);
  MarkdownRow()
      .text(ruleName(rule))
      .count(run.points)
      .count(run.triangles)
      .number(run.seconds, 1)
      .number(1e6 * run.seconds / points, 2)
      .number(percent(run.used_points, run.points), 1)
      .number(peak / points, 0)
      .number(1e-9 * peak, 2)
      .print();
}

} // namespace

void
printMapSpeed(const std::string& standard_scene)
{
  std::cout << "\n### All views, raw\n";
  printHead({"mesher",
             "points",
             "triangles",
             "CPU s",
             "CPU us a point",
             "points used %",
             "peak on top of the input, bytes a point",
             "GB"});
  for (const DeWallRule rule : {DeWallRule::Paper, DeWallRule::Dense})
    printRow(rule, runInChild([&] { return meshMap(standard_scene, rule); }));
}

} // namespace pcl::acmap::bench
