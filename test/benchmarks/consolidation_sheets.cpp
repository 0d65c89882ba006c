#include "consolidation_tables.h"

#include "consolidated_mesh.h"
#include "markdown_row.h"
#include "sheet_figures.h"

#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr double depth_reach = 5;  // mm
constexpr double cover_reach = 97; // percent

std::int32_t
planeNamed(const SimulatedScene& scene, const std::string& name)
{
  const auto& planes = scene.geometry.planes();
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (planes[i].name == name)
      return static_cast<std::int32_t>(i);
  throw BadArgumentException("scene '" + scene.name + "' has no plane '" + name + "'");
}

void
printRows(SceneData& data, const std::vector<std::string>& planes)
{
  for (const double voxel : {0.04, 0.05, 0.07, 0.0}) {
    ConsolidationReport report;
    const SimulatedCloud& cloud = data.whole();
    const Consolidation consolidation = consolidate(cloud, voxel, report);
    const test::Points places = placesInScene(cloud, consolidation);
    const test::Points normals = normalsInScene(cloud, consolidation);
    for (const std::string& plane : planes) {
      const SheetFigures sheet = measureSheet(data.wholeTruth(),
                                              planeNamed(data.scene(), plane),
                                              places,
                                              normals,
                                              report.voxel_size);
      MarkdownRow()
          .text(plane)
          .text(voxelName(voxel))
          .number(100 * report.voxel_size, 1)
          .count(sheet.representatives)
          .atLeast(sheet.cover, cover_reach, 1)
          .atMost(1000 * sheet.depth_error, depth_reach, 2)
          .number(1000 * sheet.p95_depth_error, 1)
          .within(1000 * sheet.shift, depth_reach, 2)
          .number(sheet.turned, 2)
          .print();
    }
  }
}

} // namespace

void
printSheets(SceneData& corridor)
{
  std::cout << "\n### Thin walls and recesses\n";
  printHead({"sheet",
             "voxel",
             "cm",
             "representatives",
             "kept: covered %",
             "depth error, mean mm",
             "p95 mm",
             "shift, mm",
             "turned %"});
  SceneData office("office");
  printRows(office, {"partition left", "partition right"});
  printRows(corridor, {"doors left", "left wall", "doors right", "right wall"});
}

} // namespace pcl::acmap::bench
