#include <pcl/visualization/display_connection.h>
#include <pcl/visualization/mesh_snapshot.h>

#include "camera.h"
#include "picture.h"
#include "scene.h"
#include "scene_renderer.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

namespace pcl {
namespace {

vtkSmartPointer<vtkRenderer>
rendererOf(const PCLPointCloud2& cloud, const TriangleMesh& mesh, const SceneView& view)
{
  acmap::Scene scene = acmap::makeScene(cloud, mesh);
  if (view.ignore_colors)
    scene.colors.clear();
  const acmap::Camera camera =
      acmap::placeCamera(scene.points, acmap::meanNormal(scene), view);
  return acmap::makeRenderer(scene, camera, view);
}

} // namespace

void
saveSnapshot(const std::string& path,
             const PCLPointCloud2& cloud,
             const TriangleMesh& mesh,
             const SceneView& view)
{
  const acmap::DisplayConnection display;
  acmap::savePicture(path, rendererOf(cloud, mesh, view), view);
}

void
saveSnapshot(const std::string& path, const PolygonMesh& mesh, const SceneView& view)
{
  saveSnapshot(path, mesh.cloud, acmap::trianglesOf(mesh), view);
}

void
showScene(const std::string& title,
          const PCLPointCloud2& cloud,
          const TriangleMesh& mesh,
          const SceneView& view)
{
  const acmap::DisplayConnection display;
  const auto window = acmap::makeWindow(rendererOf(cloud, mesh, view), view);
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(style);
  window->Render();
  window->SetWindowName(title.c_str());
  interactor->Start();
}

void
showScene(const std::string& title, const PolygonMesh& mesh, const SceneView& view)
{
  showScene(title, mesh.cloud, acmap::trianglesOf(mesh), view);
}

} // namespace pcl
