#include <pcl/visualization/display_connection.h>
#include <pcl/visualization/mesh_snapshot.h>

#include "camera.h"
#include "png_file.h"
#include "scene.h"
#include "scene_renderer.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkWindowToImageFilter.h>

namespace pcl {
namespace {

constexpr int samples_a_pixel = 4;

/** \brief A window with the scene in it, not yet drawn. */
vtkSmartPointer<vtkRenderWindow>
makeWindow(const PCLPointCloud2& cloud, const TriangleMesh& mesh, const SceneView& view)
{
  acmap::Scene scene = acmap::makeScene(cloud, mesh);
  if (view.ignore_colors)
    scene.colors.clear();
  const acmap::Camera camera =
      acmap::placeCamera(scene.points, acmap::meanNormal(scene), view);
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetSize(view.width, view.height);
  window->SetMultiSamples(samples_a_pixel);
  window->AddRenderer(acmap::makeRenderer(scene, camera, view));
  return window;
}

} // namespace

void
saveSnapshot(const std::string& path,
             const PCLPointCloud2& cloud,
             const TriangleMesh& mesh,
             const SceneView& view)
{
  const acmap::DisplayConnection display;
  const auto window = makeWindow(cloud, mesh, view);
  window->SetOffScreenRendering(1);
  window->Render();
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  pixels->SetInputBufferTypeToRGB();
  pixels->ReadFrontBufferOff();
  pixels->Update();
  acmap::writePng(path, pixels->GetOutput());
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
  const auto window = makeWindow(cloud, mesh, view);
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
