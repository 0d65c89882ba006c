#include "consolidation_tables.h"

#include "consolidated_mesh.h"
#include "markdown_row.h"
#include "mesh_figures.h"
#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

/** Targets for a mesh. */
struct MeshReach {
  double median, p95;           // degrees
  double cover, area, boundary; // percent
};

constexpr MeshReach whole_reach{0.7, 5, 97, 2, 1.5};
constexpr MeshReach view_reach{1.2, 6, 97, 3, 2.5};
constexpr MeshReach sparse_reach{no_reach, no_reach, 95, no_reach, 4};

struct MeasuredMesh {
  double voxel; // metres
  std::size_t representatives, triangles;
  MeshFigures figures;
};

MeasuredMesh
meshAndMeasure(const SimulatedCloud& cloud, double voxel, const SceneTruth& truth)
{
  ConsolidationReport report;
  const Consolidation consolidation = consolidate(cloud, voxel, report);
  const TriangleMesh mesh = meshOf(consolidation, report.voxel_size);
  return {report.voxel_size,
          consolidation.representatives.size(),
          mesh.triangles.size(),
          measureMesh(truth,
                      placesInScene(cloud, consolidation),
                      mesh.triangles,
                      report.voxel_size)};
}

void
printRow(const SimulatedCloud& cloud,
         double voxel,
         const SceneTruth& truth,
         const MeshReach& reach)
{
  const MeasuredMesh mesh = meshAndMeasure(cloud, voxel, truth);
  const MeshFigures& figures = mesh.figures;
  MarkdownRow()
      .text(cloud.name + ", " + voxelName(voxel))
      .number(100 * mesh.voxel, 1)
      .count(mesh.representatives)
      .count(mesh.triangles)
      .atMost(figures.normals.median_away, reach.median, 2)
      .atMost(figures.normals.p95_away, reach.p95, 1)
      .number(figures.normals.backs_away, 2)
      .atMost(figures.normals.median_all, reach.median, 2)
      .number(figures.normals.p95_all, 1)
      .number(figures.normals.backs_all, 2)
      .atLeast(figures.cover, reach.cover, 2)
      .number(figures.overlap, 1)
      .within(figures.area, reach.area, 2)
      .atMost(figures.boundary, reach.boundary, 2)
      .print();
}

/** Prints one figure of many views; larger values are worse. */
void
printSpread(const char* name, const std::vector<double>& values, double reach)
{
  const auto missed = std::count_if(
      values.begin(), values.end(), [reach](double v) { return !(v <= reach); });
  MarkdownRow()
      .text(name)
      .number(median(values), 2)
      .atMost(quantile(values, 1), reach, 2)
      .count(static_cast<std::size_t>(missed))
      .print();
}

void
printEveryView(const SceneData& corridor)
{
  std::vector<double> medians, p95s, uncovered, areas, boundaries;
  for (std::size_t view = 0; view < corridor.scene().views.size(); ++view) {
    const MeshFigures figures = meshAndMeasure(makeViewCloud(corridor.scene(), view),
                                               0,
                                               corridor.truthOfView(view))
                                    .figures;
    medians.push_back(figures.normals.median_all);
    p95s.push_back(figures.normals.p95_away);
    uncovered.push_back(100 - figures.cover);
    areas.push_back(std::abs(figures.area));
    boundaries.push_back(figures.boundary);
  }
  std::cout << "\nEach of the " << medians.size() << " views alone, automatic voxel:\n";
  printHead({"figure", "median view", "worst view", "views that miss"});
  printSpread("all faces, median °", medians, view_reach.median);
  printSpread("faces away from creases, p95 °", p95s, view_reach.p95);
  printSpread("not covered %", uncovered, 100 - view_reach.cover);
  printSpread("area, off by %", areas, view_reach.area);
  printSpread("boundary edges %", boundaries, view_reach.boundary);
}

} // namespace

void
printMesh(SceneData& corridor)
{
  std::cout << "\n### Meshes of consolidated clouds\n";
  printHead({"cloud, voxel",
             "cm",
             "representatives",
             "triangles",
             "face normals away from creases, median °",
             "p95 °",
             "backs %",
             "all faces, median °",
             "p95 °",
             "backs %",
             "cover %",
             "covered twice %",
             "area %",
             "boundary edges %"});
  for (const std::size_t view : {0, 40, 53})
    printRow(makeViewCloud(corridor.scene(), view),
             0,
             corridor.truthOfView(view),
             view_reach);
  const SimulatedCloud& whole = corridor.whole();
  const SceneTruth& truth = corridor.wholeTruth();
  for (const std::size_t size : {100000, 1000000})
    printRow(makeRandomPart(whole, size, size), 0, truth, sparse_reach);
  for (const double voxel : {0.05, 0.0})
    printRow(whole, voxel, truth, whole_reach);
  printEveryView(corridor);
}

} // namespace pcl::acmap::bench
