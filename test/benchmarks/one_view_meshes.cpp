#include "one_view_tables.h"

#include "bench_data.h"
#include "markdown_row.h"
#include "mesh_figures.h"
#include "one_view_finders.h"
#include "statistics.h"

#include <pcl/simulation/standard_scenes.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

// At larger distances the noise of a Kinect exceeds the tolerance.
constexpr double truth_reach = 4.0; // metres
constexpr double tolerance = 0.1;   // metres, three standard deviations there

struct NamedMesher {
  const char* name;
  OneViewMesh (*mesh)(const OneView&);
};

constexpr NamedMesher meshers[] = {{"acmap", ourMesh},
                                   {"PCL organized fast mesh", organizedMesh},
                                   {"PCL greedy projection", greedyMesh}};

/** \brief The truth and the pose of the view. */
struct ViewTruth {
  SceneTruth scene;
  Eigen::Isometry3d T_scene_camera;
};

/** \param[in] truth may be null */
void
printMeshes(const OneView& view, const ViewTruth* truth)
{
  for (const NamedMesher& mesher : meshers) {
    OneViewMesh mesh = mesher.mesh(view);
    const test::MeshCounts counts = test::countMesh(mesh.points, mesh.triangles);
    MarkdownRow row;
    row.text(view.name)
        .count(view.finite.points->size())
        .text(mesher.name)
        .count(mesh.triangles.size())
        .number(percent(counts.boundary_edges, counts.edges), 2);
    if (truth) {
      for (Eigen::Vector3d& point : mesh.points)
        point = truth->T_scene_camera * point;
      row.number(
          measureMesh(truth->scene, mesh.points, mesh.triangles, 2 * tolerance).cover,
          1);
    }
    else
      row.text("–");
    row.number(mesh.seconds, 2).print();
  }
}

} // namespace

void
printViewMeshes()
{
  std::cout << "\n### One view as a mesh\n";
  printHead({"view",
             "points",
             "mesher",
             "triangles",
             "boundary edges %",
             "cover %",
             "CPU s"});
  for (const auto& [name, path] : {std::pair{"office1", "E_meshing/office1.pcd"},
                                   {"capture0001", "E_meshing/capture0001.pcd"}})
    if (const std::optional<std::string> found = pathOfData(path))
      printMeshes(loadOneView(name, *found), nullptr);
  for (const char* const name : {"office", "corridor", "loop"}) {
    SimulatedScene scene = standardScene(name);
    useKinect(scene);
    scene.sensor.reach = truth_reach;
    ViewTruth truth{SceneTruth(scene), scene.views[0]};
    truth.scene.see(scene, 0, 4);
    printMeshes(makeTrueView(scene, 0).view, &truth);
  }
}

} // namespace pcl::acmap::bench
