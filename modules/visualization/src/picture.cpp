#include "picture.h"

#include <pcl/core/output_file.h>

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <string>

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
setBackground(bool light, vtkRenderer* renderer)
{
  if (light) {
    renderer->SetBackground(0.97, 0.97, 0.96);
    renderer->SetBackground2(0.80, 0.84, 0.89);
  }
  else {
    renderer->SetBackground(0.10, 0.11, 0.13);
    renderer->SetBackground2(0.20, 0.23, 0.27);
  }
  renderer->GradientBackgroundOn();
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
makeStage(const Camera& camera, bool light)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  setBackground(light, renderer);
  addLights(renderer);
  setCamera(camera, renderer);
  return renderer;
}

} // namespace pcl::acmap
