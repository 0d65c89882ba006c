#include "map_drawing.h"

#include "plan_lines.h"
#include "scale_bar.h"

#include <algorithm>

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
  return actorsOfTextures(drawn(cutFaces(map_, faces_)), hides_backs_);
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
  return view_.place != MapView::Place::Plan ||
         !looksDown(map_.planes[plane], frame_.up);
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

} // namespace pcl::acmap
