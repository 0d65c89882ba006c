#include "picture.h"

#include <pcl/core/output_file.h>

#include <vtkCamera.h>
#include <vtkEDLShading.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPNGWriter.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkRenderStepsPass.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <string>
#include <vector>

namespace pcl::acmap {

namespace {

/** \brief Writes an image as PNG, completely or not at all.
 * \throws OutputFileException */
void
writePng(const std::string& path, vtkImageData* picture)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  if (!bytes || bytes->GetNumberOfValues() == 0)
    throw OutputFileException(shownPath(path) + ": the picture could not be encoded");
  OutputFile file(path);
  file.write(bytes->GetPointer(0),
             static_cast<std::size_t>(bytes->GetNumberOfValues()));
  file.commit();
}

/** \brief A key light from above on the left of the camera, and a weak light from the
 * camera. */
void
addLights(vtkRenderer* renderer)
{
  struct Lamp {
    double x, y, z, intensity;
  };
  for (const Lamp& lamp : {Lamp{-0.7, 0.9, 1.0, 0.75}, Lamp{0.3, 0.0, 1.0, 0.35}}) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(lamp.x, lamp.y, lamp.z);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(lamp.intensity);
    renderer->AddLight(light);
  }
}

/** \brief Something that is not drawn, whose bounds are many times those of the scene. */
class Ballast : public vtkProp {
public:
  static Ballast*
  New();
  vtkTypeMacro(Ballast, vtkProp);

  double*
  GetBounds() override
  {
    return bounds;
  }

  double bounds[6];
};

vtkStandardNewMacro(Ballast);

/** \brief VTK's shading divides depths by the size of the scene: as it has it, noise of a
 * percent of that is black. */
class SoftShading : public vtkEDLShading {
public:
  static SoftShading*
  New();
  vtkTypeMacro(SoftShading, vtkEDLShading);

  void
  Render(const vtkRenderState* state) override
  {
    constexpr double times = 30; // the size of the scene
    vtkRenderer* const renderer = state->GetRenderer();
    renderer->ComputeVisiblePropBounds(ballast_->bounds);
    for (int i = 0; i < 6; i += 2) {
      const double more =
          (times - 1) / 2 * (ballast_->bounds[i + 1] - ballast_->bounds[i]);
      ballast_->bounds[i] -= more;
      ballast_->bounds[i + 1] += more;
    }
    std::vector<vtkProp*> props(state->GetPropArray(),
                                state->GetPropArray() + state->GetPropArrayCount());
    props.push_back(ballast_);
    vtkRenderState heavier(renderer);
    heavier.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
    heavier.SetFrameBuffer(state->GetFrameBuffer());
    vtkOpenGLState& before =
        *static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
    before.Push(); // else texts over the scene are blended in another way
    Superclass::Render(&heavier);
    before.Pop();
  }

private:
  vtkNew<Ballast> ballast_;
};

vtkStandardNewMacro(SoftShading);

} // namespace

vtkSmartPointer<vtkRenderWindow>
makeWindow(vtkRenderer* renderer, const SceneView& view)
{
  constexpr int samples_a_pixel = 4;
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetSize(view.width, view.height);
  window->SetMultiSamples(samples_a_pixel);
  window->AddRenderer(renderer);
  return window;
}

void
savePicture(const std::string& path, vtkRenderer* renderer, const SceneView& view)
{
  const auto window = makeWindow(renderer, view);
  window->SetOffScreenRendering(1);
  window->Render();
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  pixels->SetInputBufferTypeToRGB();
  pixels->ReadFrontBufferOff();
  pixels->Update();
  writePng(path, pixels->GetOutput());
}

void
shadeDepths(bool on, vtkRenderer* renderer)
{
  if (on == (renderer->GetPass() != nullptr))
    return;
  if (!on) {
    if (renderer->GetRenderWindow())
      renderer->GetPass()->ReleaseGraphicsResources(renderer->GetRenderWindow());
    renderer->SetPass(nullptr);
    return;
  }
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<SoftShading> shading;
  shading->SetDelegatePass(steps);
  renderer->SetPass(shading);
}

void
setCamera(const Camera& camera, vtkRenderer* renderer)
{
  vtkCamera* const active = renderer->GetActiveCamera();
  active->SetPosition(camera.position.data());
  active->SetFocalPoint(camera.focus.data());
  active->SetViewUp(camera.up.data());
  active->SetViewAngle(camera.view_angle);
  active->SetClippingRange(camera.near, camera.far);
  active->SetParallelProjection(camera.parallel_height > 0);
  active->SetParallelScale(camera.parallel_height / 2);
}

vtkSmartPointer<vtkRenderer>
makeStage(const Camera& camera)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(background.data());
  addLights(renderer);
  setCamera(camera, renderer);
  return renderer;
}

} // namespace pcl::acmap
