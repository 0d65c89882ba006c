#include "mesh_figures.h"

#include "consolidation_stage.h"
#include "exit_code.h"
#include "figure_sheet.h"
#include "figure_views.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/surface/dewall_kernel.h>

namespace pcl::acmap {

namespace {

struct ObservationMesh {
  PCLPointCloud2 vertices;
  TriangleMesh mesh;
};

/** The mesh of an observation's cloud at its noise scale, with the depths of its walls. */
ObservationMesh
meshOf(const std::string& path, std::int32_t leaf_size, unsigned threads)
{
  const PointCloudFile file = loadPointCloud(path);
  const Eigen::Vector3f origin = Eigen::Vector3f::Zero(); // the camera's own frame
  ConsolidationSettings settings;
  settings.threads = threads;
  ConsolidationReport report;
  ConsolidatedCloud cloud =
      consolidatedCloud(file, SensorView(origin), settings, {}, report);
  DeWallSettings wall;
  wall.maximum_edge_length = edges_of_voxel * report.voxel_size;
  wall.compute_wall_depth = true;
  wall.leaf_size = leaf_size;
  wall.threads = threads;
  const auto& all = cloud.consolidation.representatives;
  if (!all.empty())
    wall.normals = PointView(all.front().normal.data(), sizeof all[0], all.size());
  DeWallReport made;
  ObservationMesh result;
  result.mesh = triangulateDeWall(cloud.file.points(), wall, Progress(), made);
  if (result.mesh.triangles.empty())
    throw NothingFound(path + ": no triangle is possible");
  result.vertices = std::move(cloud.file.cloud);
  return result;
}

RgbImage
wallsFigure(const ObservationMesh& observation,
            const FigurePlan& plan,
            const OutputFolder& folder)
{
  LayeredScene scene;
  scene.vertices = scene.points = observation.vertices;
  lighten(scene.points);
  scene.mesh = observation.mesh;
  std::vector<std::vector<RgbImage>> rows(1);
  const std::size_t steps = std::min(plan.wall_steps, wallSteps(observation.mesh));
  for (std::size_t step = 0; step < steps; ++step) {
    auto view = viewFrom<LayeredView>(plan.walls.eye);
    view.layers = {SceneLayer::Points, SceneLayer::Mesh};
    view.wall_step = step;
    if (rows.back().size() == 2)
      rows.emplace_back();
    rows.back().push_back(drawn(
        folder, [&](const std::string& path) { saveSnapshot(path, scene, view); }));
  }
  return sheetOf(rows, plan.width);
}

RgbImage
meshFigure(const ObservationMesh& observation,
           const FigurePlan& plan,
           const OutputFolder& folder)
{
  constexpr int finer = 2; // its edges are thinner than a pixel
  const int width = plan.width, height = plan.width * 3 / 4;
  auto view = viewFrom(plan.mesh.eye, finer * width, finer * height);
  view.ignore_colors = true;
  view.show_edges = true;
  return resized(drawn(folder,
                       [&](const std::string& path) {
                         saveSnapshot(
                             path, observation.vertices, observation.mesh, view);
                       }),
                 width,
                 height);
}

} // namespace

void
drawMeshes(const MappedSession& map,
           const FigurePlan& plan,
           unsigned threads,
           const OutputFolder& folder)
{
  // as many points as make walls that can be told apart; else the usual ones
  constexpr std::int32_t small_leaf = 256;
  const auto path = [&](const ObservationFigure& figure) {
    return map.observations[figure.observation];
  };
  savePng(folder.path("fig5.png"),
          wallsFigure(meshOf(path(plan.walls), small_leaf, threads), plan, folder));
  savePng(
      folder.path("fig7.png"),
      withFewLevels(meshFigure(
          meshOf(path(plan.mesh), DeWallSettings().leaf_size, threads), plan, folder)));
}

} // namespace pcl::acmap
