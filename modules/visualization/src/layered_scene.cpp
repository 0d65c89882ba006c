#include <pcl/visualization/display_connection.h>
#include <pcl/visualization/layered_scene.h>

#include "layer_keys.h"
#include "layer_stage.h"
#include "picture.h"

#include <vtkRenderWindowInteractor.h>

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

void
showScene(const std::string& title,
          const LayeredScene& scene,
          const LayeredView& view,
          const std::function<void(const std::string&)>& tell)
{
  const acmap::DisplayConnection display;
  acmap::LayerStage stage(scene, view);
  const auto window = acmap::makeWindow(stage.renderer(), view);
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<acmap::LayerKeys> keys;
  keys->attach(stage, scene, tell);
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(keys);
  window->Render();
  window->SetWindowName(title.c_str());
  interactor->Start();
}

} // namespace pcl
