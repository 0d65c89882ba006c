#include "map_drawing.h"

#include "plan_lines.h"
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

MapDrawing::MapDrawing(const CompactMap& map, const MapView& view)
: map_(map)
, view_(view)
, hides_backs_(view.hide_backs || view.place != MapView::Place::Inside)
{
  requireSound(view);
  faces_ = facesOf(map);
  samples_ = samplesOf(faces_);
  frame_ = frameOf(map, samples_, view);
  camera_ = placeMapCamera(map, faces_, samples_, frame_, view);
}

std::vector<MapFaces>
MapDrawing::drawnFaces() const
{
  return drawn(faces_);
}

Actors
MapDrawing::textures() const
{
  return actorsOfTextures(drawn(cutFaces(map_, faces_)), map_.exposure, hides_backs_);
}

Actors
MapDrawing::planes(double opacity) const
{
  return actorsOfPlanes(drawnFaces(), hides_backs_, opacity);
}

Actors
MapDrawing::outlines() const
{
  std::vector<MapLine> lines;
  for (std::size_t plane = 0; plane < map_.planes.size(); ++plane)
    if (isDrawn(plane))
      append(lines, outlinesOf(map_, plane));
  for (std::size_t i = 0; i < map_.cylinders.size(); ++i)
    if (isDrawn(map_.planes.size() + i))
      append(lines, rimOf(map_, i));
  return {actorOfOutlines(lines)};
}

void
MapDrawing::addPlanTo(vtkRenderer* renderer) const
{
  if (view_.place != MapView::Place::Plan)
    return;
  for (const auto& actor : actorsOfPlan(map_, frame_.up, samples_))
    renderer->AddActor(actor);
  addScaleBar(camera_, view_, renderer);
}

bool
MapDrawing::isDrawn(std::size_t plane) const
{
  if (view_.place != MapView::Place::Plan)
    return true;
  const std::size_t planes = map_.planes.size();
  return plane < planes ? !looksDown(map_.planes[plane], frame_.up)
                        : !looksDown(map_.cylinders[plane - planes], frame_.up);
}

std::vector<MapFaces>
MapDrawing::drawn(std::vector<MapFaces> faces) const
{
  faces.erase(
      std::remove_if(faces.begin(),
                     faces.end(),
                     [&](const MapFaces& part) { return !isDrawn(part.plane); }),
      faces.end());
  return faces;
}

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
