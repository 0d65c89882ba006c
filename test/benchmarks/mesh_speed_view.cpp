#include "mesh_speed_tables.h"

#include "clouds.h"
#include "greedy_projection.h"
#include "markdown_row.h"
#include "mesh_figures.h"
#include "raw_mesh.h"
#include "simulated_points.h"
#include "statistics.h"
#include "timing.h"
#ifdef ACMAP_HAVE_CGAL
#include "planar_delaunay.h"
#endif

#include <functional>
#include <iostream>
#include <optional>

namespace pcl::acmap::bench {
namespace {

using test::Triangles;

/** A view as a PCL cloud, with its truth if there is one. */
struct SpeedView {
  std::string name;
  test::Cloud cloud;
  const SceneTruth* truth = nullptr;
  Eigen::Isometry3d T_scene_cloud = Eigen::Isometry3d::Identity();

  PointView
  points() const
  {
    return {cloud.front().data, sizeof(PointXYZ), cloud.size()};
  }
};

/** A meshing method for a view; methods that are only a lower bound return no mesh. */
struct SpeedMesher {
  std::string name;
  std::size_t rounds;
  std::function<std::optional<Triangles>()> mesh;
  std::vector<double> seconds;
  std::optional<Triangles> result;
};

SpeedMesher
deWallMesher(const SpeedView& view, DeWallRule rule, std::size_t rounds)
{
  return {ruleName(rule),
          rounds,
          [&view, rule] { return meshRaw(view.points(), rule).mesh.triangles; },
          {},
          {}};
}

std::vector<SpeedMesher>
speedMeshers(const SpeedView& view, std::size_t rounds)
{
  std::vector<SpeedMesher> all{deWallMesher(view, DeWallRule::Paper, rounds),
                               deWallMesher(view, DeWallRule::Dense, rounds)};
#ifdef ACMAP_HAVE_CGAL
  all.push_back({"lower bound: CGAL 2D Delaunay of x and y",
                 rounds,
                 [&view] {
                   planarDelaunay(view.points());
                   return std::nullopt;
                 },
                 {},
                 {}});
#endif
  const double spacing = test::medianSpacing(test::toPoints(view.cloud));
  all.push_back({"PCL greedy projection",
                 1,
                 [&view, spacing] { return greedyProjection(view.cloud, spacing); },
                 {},
                 {}});
  return all;
}

void
addTruthCells(const SpeedView& view, const Triangles& mesh, MarkdownRow& row)
{
  // Nearly all points are within three standard deviations of the largest noise.
  constexpr double tolerance = 0.09; // metres
  if (!view.truth) {
    row.text("–").text("–").text("–");
    return;
  }
  test::Points places = test::toPoints(view.cloud);
  for (Eigen::Vector3d& place : places)
    place = view.T_scene_cloud * place;
  const MeshFigures figures = measureMesh(*view.truth, places, mesh, 2 * tolerance);
  row.number(figures.cover, 2).number(figures.overlap, 1).number(figures.area, 1);
}

void
addMeshCells(const SpeedView& view, const SpeedMesher& mesher, MarkdownRow& row)
{
  if (!mesher.result) {
    for (int cell = 0; cell < 6; ++cell)
      row.text("–");
    return;
  }
  const Triangles& mesh = *mesher.result;
  const test::MeshCounts counts = test::countMesh(test::toPoints(view.cloud), mesh);
  row.number(percent(counts.used_points, view.cloud.size()), 1)
      .count(mesh.size())
      .number(percent(counts.boundary_edges, counts.edges), 1);
  addTruthCells(view, mesh, row);
}

void
printRows(const SpeedView& view, std::size_t rounds)
{
  std::vector<SpeedMesher> meshers = speedMeshers(view, rounds);
  for (std::size_t round = 0; round < rounds; ++round)
    for (SpeedMesher& mesher : meshers)
      if (round < mesher.rounds)
        mesher.seconds.push_back(measureThread([&] { mesher.result = mesher.mesh(); }));
  const double greedy = median(meshers.back().seconds);
  for (const SpeedMesher& mesher : meshers) {
    const double seconds = median(mesher.seconds);
    MarkdownRow row;
    row.text(view.name)
        .count(view.cloud.size())
        .text(mesher.name)
        .number(1e6 * seconds / static_cast<double>(view.cloud.size()), 2)
        .text(timesOf(greedy, seconds));
    addMeshCells(view, mesher, row);
    row.print();
  }
}

} // namespace

void
printViewSpeed(const SceneData& corridor, std::size_t rounds)
{
  std::cout << "\n### One view, raw\n";
  printHead({"view",
             "points",
             "mesher",
             "CPU us a point",
             "greedy projection takes",
             "points used %",
             "triangles",
             "boundary edges %",
             "cover %",
             "covered twice %",
             "area beyond the truth's %"});
  const SimulatedCloud first = makeViewCloud(corridor.scene(), 0);
  const SceneTruth truth = corridor.truthOfView(0);
  printRows({first.name, *plainPoints(first), &truth, first.T_scene_cloud}, rounds);
  printRows({"simulated corridor view", test::makeCorridorView(138654, 1)}, rounds);
}

} // namespace pcl::acmap::bench
