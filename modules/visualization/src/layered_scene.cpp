#include <pcl/visualization/display_connection.h>
#include <pcl/visualization/layered_scene.h>

#include "layer_keys.h"
#include "layer_stage.h"
#include "overlay.h"
#include "picture.h"

#include <vtkAxesActor.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkRenderWindowInteractor.h>

#include <optional>

namespace pcl {

void
saveSnapshot(const std::string& path,
             const LayeredScene& scene,
             const LayeredView& view)
{
  const acmap::DisplayConnection display;
  acmap::LayerStage stage(scene, view);
  stage.addPictureMarks();
  acmap::savePicture(path, stage.renderer(), view);
}

struct SceneWindow::Parts {
  Parts(const std::string& name, int width, int height)
  : name(name)
  {
    SceneView size;
    size.width = width;
    size.height = height;
    acmap::requireSound(size);
    empty->SetBackground(acmap::background.data());
    window = acmap::makeWindow(empty, size);
    window->SetWindowName(name.c_str());
    overlay.emplace(*window);
    overlay->setNotice("Reading " + name + " ...");
    interactor->SetRenderWindow(window);
    window->Render();
  }

  acmap::DisplayConnection display; // needed as long as VTK draws
  std::string name;
  vtkNew<vtkRenderer> empty;
  vtkSmartPointer<vtkRenderWindow> window;
  std::optional<acmap::Overlay> overlay;
  vtkNew<vtkRenderWindowInteractor> interactor;
};

SceneWindow::SceneWindow(const std::string& name, int width, int height)
: parts_(std::make_unique<Parts>(name, width, height))
{}

SceneWindow::~SceneWindow() = default;

void
SceneWindow::show(const LayeredScene& scene,
                  const LayeredView& view,
                  const std::function<void(const std::string&)>& tell)
{
  acmap::LayerStage stage(scene, view);
  const vtkSmartPointer<vtkRenderWindow> window = parts_->window;
  window->RemoveRenderer(parts_->empty);
  window->AddRenderer(stage.renderer());
  window->SetWindowName((parts_->name + ": " + acmap::describeScene(scene)).c_str());
  parts_->overlay->setNotice({});
  vtkNew<acmap::LayerKeys> keys;
  keys->attach(stage, scene, *parts_->overlay, tell);
  parts_->interactor->SetInteractorStyle(keys);
  vtkNew<vtkAxesActor> axes;
  vtkNew<vtkOrientationMarkerWidget> marker;
  marker->SetOrientationMarker(axes);
  marker->SetInteractor(parts_->interactor);
  marker->SetCurrentRenderer(stage.renderer());
  marker->SetViewport(0.88, 0, 1, 0.16);
  marker->EnabledOn();
  marker->InteractiveOff();
  window->Render();
  parts_->interactor->Start();
  marker->EnabledOff();
  window->RemoveRenderer(stage.renderer());
}

void
showScene(const std::string& title,
          const LayeredScene& scene,
          const LayeredView& view,
          const std::function<void(const std::string&)>& tell)
{
  SceneWindow(title, view.width, view.height).show(scene, view, tell);
}

} // namespace pcl
