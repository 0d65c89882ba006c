#include "picture.h"

#include "png_file.h"

#include <vtkNew.h>
#include <vtkWindowToImageFilter.h>

namespace pcl::acmap {

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

} // namespace pcl::acmap
