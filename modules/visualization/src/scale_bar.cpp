#include "scale_bar.h"

#include "vtk_pieces.h"

#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl::acmap {

double
roundLength(double maximum)
{
  const double power = std::pow(10, std::floor(std::log10(maximum)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= maximum)
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

ScaleBar::ScaleBar()
{
  corners_->SetNumberOfPoints(4);
  vtkNew<vtkPolyData> data;
  data->SetPoints(corners_);
  data->SetLines(cellsOf(std::vector<std::array<std::int32_t, 4>>{{0, 1, 2, 3}}));
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  bar_->SetMapper(mapper);
  bar_->GetProperty()->SetColor(0.1, 0.1, 0.1);
  text_->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
  text_->GetTextProperty()->SetJustificationToCentered();
}

void
ScaleBar::addTo(vtkRenderer* renderer)
{
  renderer->AddActor2D(bar_);
  renderer->AddActor2D(text_);
}

void
ScaleBar::set(double metres, int width, int height)
{
  constexpr double max_share = 0.25; // of the width
  const double length = roundLength(width * max_share * metres);
  const auto unit = static_cast<float>(std::max(4.0, height / 120.0));
  const float left = 3 * unit, bottom = 2.5F * unit;
  const auto right = left + static_cast<float>(length / metres);
  corners_->SetPoint(0, left, bottom + unit, 0);
  corners_->SetPoint(1, left, bottom, 0);
  corners_->SetPoint(2, right, bottom, 0);
  corners_->SetPoint(3, right, bottom + unit, 0);
  corners_->Modified();
  bar_->GetProperty()->SetLineWidth(unit / 3);
  text_->SetInput(lengthText(length).c_str());
  text_->GetTextProperty()->SetFontSize(static_cast<int>(3 * unit));
  text_->SetPosition((left + right) / 2, bottom + 0.6F * unit);
}

void
addScaleBar(const Camera& camera, const SceneView& view, vtkRenderer* renderer)
{
  ScaleBar bar;
  bar.set(camera.parallel_height / view.height, view.width, view.height);
  bar.addTo(renderer);
}

} // namespace pcl::acmap
