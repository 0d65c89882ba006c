#include "figures.h"

#include "exit_code.h"
#include "figure_sheet.h"
#include "figure_views.h"

#include <pcl/conversions.h>
#include <pcl/core/cloud_fields.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/point_types.h>
#include <pcl/surface/dewall_triangulation.h>

namespace pcl::acmap {

namespace {

struct ObservationMesh {
  PCLPointCloud2 vertices;
  TriangleMesh mesh;
};

using DeWall = DeWallTriangulation<PointNormal>;

/** The mesh of an observation's cloud at its noise scale, with the recursion depths of
 * its walls. */
ObservationMesh
meshOf(const std::string& path, DeWall dewall, unsigned threads)
{
  VoxelConsolidation<PCLPointCloud2> consolidation;
  consolidation.setInputCloud(
      std::make_shared<const PCLPointCloud2>(loadPointCloud(path).cloud));
  // the cloud is in the camera's frame
  consolidation.setSensorOrigin(Eigen::Vector3f::Zero());
  consolidation.setNumberOfThreads(threads);
  ObservationMesh result;
  consolidation.filter(result.vertices);
  const PointCloud<PointNormal>::Ptr vertices(new PointCloud<PointNormal>);
  fromPCLPointCloud2(result.vertices, *vertices);
  dewall.setInputCloud(vertices);
  dewall.setMaximumEdgeLength(mesh_edge_in_voxels *
                              consolidation.getReport().voxel_size);
  dewall.setComputeWallDepth(true);
  dewall.setNumberOfThreads(threads);
  dewall.reconstruct(result.mesh);
  if (result.mesh.triangles.empty())
    throw NothingFound(path + ": no triangle is possible");
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
  constexpr int finer = 2; // oversampling, since mesh edges are thinner than a pixel
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
  // so few points that single walls can be distinguished
  constexpr int small_leaf = 256;
  DeWall usual, with_walls;
  with_walls.setLeafSize(small_leaf);
  const auto path = [&](const ObservationFigure& figure) {
    return map.observations[figure.observation];
  };
  savePng(folder.path("fig5.png"),
          wallsFigure(meshOf(path(plan.walls), with_walls, threads), plan, folder));
  savePng(
      folder.path("fig7.png"),
      withFewLevels(meshFigure(meshOf(path(plan.mesh), usual, threads), plan, folder)));
}

} // namespace pcl::acmap
