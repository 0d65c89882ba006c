#include "scale_bar.h"

#include "vtk_pieces.h"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl::acmap {

double
roundLength(double most)
{
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= most)
      return digit * power;
  return power;
}

std::string
lengthText(double metres)
{
  char text[32];
  if (metres >= 1000)
    std::snprintf(text, sizeof text, "%.6g km", metres / 1000);
  else if (metres >= 1)
    std::snprintf(text, sizeof text, "%.6g m", metres);
  else if (metres >= 0.01)
    std::snprintf(text, sizeof text, "%.6g cm", metres * 100);
  else
    std::snprintf(text, sizeof text, "%.6g mm", metres * 1000);
  return text;
}

void
addScaleBar(const Camera& camera, const SceneView& view, vtkRenderer* renderer)
{
  constexpr double max_share = 0.25;                          // of the picture width
  const double pixels = view.height / camera.parallel_height; // per metre
  const double length = roundLength(view.width * max_share / pixels);
  const auto unit = static_cast<float>(std::max(4.0, view.height / 120.0));
  const float left = 3 * unit, bottom = 2.5F * unit;
  const auto right = left + static_cast<float>(length * pixels);

  vtkNew<vtkPolyData> data;
  data->SetPoints(pointsOf({{left, bottom + unit, 0},
                            {left, bottom, 0},
                            {right, bottom, 0},
                            {right, bottom + unit, 0}}));
  data->SetLines(cellsOf(std::vector<std::array<std::int32_t, 4>>{{0, 1, 2, 3}}));
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> bar;
  bar->SetMapper(mapper);
  bar->GetProperty()->SetColor(0.1, 0.1, 0.1);
  bar->GetProperty()->SetLineWidth(unit / 3);
  renderer->AddActor2D(bar);

  vtkNew<vtkTextActor> text;
  text->SetInput(lengthText(length).c_str());
  text->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
  text->GetTextProperty()->SetFontSize(static_cast<int>(3 * unit));
  text->GetTextProperty()->SetJustificationToCentered();
  text->SetPosition((left + right) / 2, bottom + 0.6F * unit);
  renderer->AddActor2D(text);
}

} // namespace pcl::acmap
