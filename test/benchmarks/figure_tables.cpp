#include "figure_tables.h"

#include "bench_data.h"
#include "coverage.h"
#include "figure_clouds.h"
#include "foreign_holes.h"
#include "greedy_projection.h"
#include "markdown_row.h"
#include "obj_mesh.h"
#include "statistics.h"
#include "surface_distance.h"
#include "timing.h"

#include <pcl/surface/dewall_triangulation.h>

#include <algorithm>
#include <functional>
#include <iomanip>
#include <iostream>
#include <set>

namespace pcl::acmap::bench {
namespace {

using test::Coverage;
using test::SheetCloud;
using test::Triangles;

Triangles
deWall(const test::Cloud& cloud, DeWallRule rule, double length = 0)
{
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setAcceptanceRule(rule);
  dewall.setMaximumEdgeLength(length);
  dewall.setNumberOfThreads(1);
  dewall.setInputCloud(cloud.makeShared());
  TriangleMesh mesh;
  dewall.reconstruct(mesh);
  return mesh.triangles;
}

/** A meshing method. */
struct Mesher {
  std::string name;
  std::function<Triangles(const FigureCloud&)> mesh;
};

std::vector<Mesher>
allMeshers()
{
  return {{"DeWall paper",
           [](const FigureCloud& c) { return deWall(c.cloud, DeWallRule::Paper); }},
          {"DeWall dense",
           [](const FigureCloud& c) { return deWall(c.cloud, DeWallRule::Dense); }},
          {"PCL greedy projection",
           [](const FigureCloud& c) { return greedyProjection(c.cloud, c.spacing); }}};
}

std::size_t
countPlaces(const test::Points& points)
{
  std::set<std::array<double, 3>> places;
  for (const Eigen::Vector3d& p : points)
    places.insert({p.x(), p.y(), p.z()});
  return places.size();
}

void
printSoundnessRow(const FigureCloud& cloud, std::size_t places, const Mesher& mesher)
{
  const test::Points points = test::toPoints(cloud.cloud);
  const Triangles mesh = mesher.mesh(cloud);
  test::MeshDemands demands;
  demands.empty_spheres = true;
  const test::MeshFaults faults = test::checkMesh(points, mesh, demands);
  const test::MeshCounts counts = test::countMesh(points, mesh);
  MarkdownRow()
      .text(cloud.name)
      .text(mesher.name)
      .count(mesh.size())
      .count(faults.crowded_edges)
      .count(faults.torn_vertices)
      .count(faults.duplicate_faces)
      .count(faults.degenerate_faces)
      .count(faults.inconsistent_edges)
      .count(faults.occupied_spheres)
      .number(percent(counts.used_points, places), 1)
      .number(percent(counts.boundary_edges, counts.edges), 1)
      .print();
}

void
printCoverageRow(const std::string& name,
                 std::size_t seeds,
                 const std::function<SheetCloud(std::uint64_t)>& makeSheet,
                 const std::function<Triangles(const SheetCloud&)>& mesh)
{
  Coverage mean;
  Coverage maximum;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const SheetCloud sheet = makeSheet(seed);
    const Coverage coverage = test::measureCoverage(sheet, mesh(sheet));
    mean.uncovered += coverage.uncovered / static_cast<double>(seeds);
    mean.overlapped += coverage.overlapped / static_cast<double>(seeds);
    maximum.uncovered = std::max(maximum.uncovered, coverage.uncovered);
    maximum.overlapped = std::max(maximum.overlapped, coverage.overlapped);
  }
  MarkdownRow()
      .text(name)
      .number(mean.uncovered, 3)
      .number(maximum.uncovered, 3)
      .number(mean.overlapped, 3)
      .number(maximum.overlapped, 3)
      .print();
}

} // namespace

void
printSoundness()
{
  printHead({"cloud",
             "mesher",
             "triangles",
             "edges with > 2 faces",
             "vertices without one fan",
             "duplicates",
             "degenerate",
             "inconsistent edges",
             "occupied spheres",
             "points used %",
             "boundary edges %"});
  for (const FigureCloud& cloud : realClouds()) {
    const std::size_t places = countPlaces(test::toPoints(cloud.cloud));
    for (const Mesher& mesher : allMeshers())
      printSoundnessRow(cloud, places, mesher);
  }
}

void
printCoverage(std::size_t seeds)
{
  printHead({"surface, noise / spacing, mesher",
             "uncovered %, mean",
             "most",
             "overlapped %, mean",
             "most"});
  const std::pair<std::string, double> surfaces[] = {{"plane", 0}, {"edge", M_PI / 2}};
  for (const auto& [surface, fold] : surfaces)
    for (const double noise : {0.1, 0.2}) {
      const auto makeSheet = [noise = noise, fold = fold](std::uint64_t seed) {
        return test::makeFoldedPlane({45, 45, 1, 0.25, noise, seed}, fold);
      };
      std::ostringstream head;
      head << surface << ", " << noise << ", ";
      for (const auto& [name, rule] : {std::pair{"paper", DeWallRule::Paper},
                                       std::pair{"dense", DeWallRule::Dense}})
        for (const double length : {3.0, 0.0})
          printCoverageRow(head.str() + name +
                               (length > 0 ? ", L = 3" : ", automatic L"),
                           seeds,
                           makeSheet,
                           [rule = rule, length](const SheetCloud& sheet) {
                             return deWall(sheet.cloud, rule, length);
                           });
      printCoverageRow(head.str() + "greedy projection",
                       seeds,
                       makeSheet,
                       [](const SheetCloud& sheet) {
                         return greedyProjection(sheet.cloud, sheet.spacing);
                       });
    }
}

void
printTime(std::size_t rounds)
{
  printHead({"view", "points", "mesher", "CPU us a point", "greedy projection takes"});
  const std::vector<Mesher> meshers = allMeshers();
  for (const FigureCloud& view : singleViews()) {
    std::vector<std::vector<double>> seconds(meshers.size());
    for (std::size_t round = 0; round < rounds; ++round)
      for (std::size_t i = 0; i < meshers.size(); ++i)
        seconds[i].push_back(measureThread([&] { meshers[i].mesh(view); }));
    for (std::size_t i = 0; i < meshers.size(); ++i) {
      std::vector<double> ratios;
      for (std::size_t round = 0; round < rounds; ++round)
        ratios.push_back(seconds.back()[round] / seconds[i][round]);
      MarkdownRow()
          .text(view.name)
          .count(view.cloud.size())
          .text(meshers[i].name)
          .number(1e6 * median(seconds[i]) / static_cast<double>(view.cloud.size()), 2)
          .text(timesOf(median(ratios), 1))
          .print();
    }
  }
}

void
printBunny()
{
  const std::optional<std::string> path = pathOfData("E_meshing/stanford-bunny.obj");
  if (!path)
    return;
  const ObjMesh model = loadObjMesh(*path);
  FigureCloud cloud{"stanford-bunny", {}, test::medianSpacing(model.points)};
  for (const Eigen::Vector3d& p : model.points)
    cloud.cloud.push_back({float(p.x()), float(p.y()), float(p.z())});

  constexpr std::size_t samples = 50000;
  std::cout << "\nMedian spacing " << std::scientific << std::setprecision(3)
            << cloud.spacing << " m; boundary loops of the model: "
            << test::countMesh(model.points, model.triangles).boundary_loops
            << ". Distances in spacings.\n";
  printHead({"mesher",
             "mesh to model, mean",
             "most",
             "model to mesh, mean",
             "most",
             "Chamfer (mean of both)",
             "boundary loops",
             "holes the model has not"});
  for (const Mesher& mesher : allMeshers()) {
    const Triangles mesh = mesher.mesh(cloud);
    const SurfaceDistance there =
        measureDistance(model.points, mesh, model.points, model.triangles, samples, 1);
    const SurfaceDistance back =
        measureDistance(model.points, model.triangles, model.points, mesh, samples, 2);
    const double unit = cloud.spacing;
    MarkdownRow()
        .text(mesher.name)
        .number(there.mean / unit, 3)
        .number(there.maximum / unit, 3)
        .number(back.mean / unit, 3)
        .number(back.maximum / unit, 3)
        .number((there.mean + back.mean) / 2 / unit, 3)
        .count(test::countMesh(model.points, mesh).boundary_loops)
        .count(countForeignHoles(model.points, mesh, model.triangles, 3 * unit))
        .print();
  }
}

} // namespace pcl::acmap::bench
