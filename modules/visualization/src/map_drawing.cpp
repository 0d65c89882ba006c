#include "map_drawing.h"

#include "plan_lines.h"
#include "scale_bar.h"

#include <pcl/core/cylinder_facets.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

/** \brief The plane of the facet in the middle of a cylinder's arc. */
Eigen::Vector4d
middleOf(const CylinderPatch& cylinder)
{
  const std::vector<PlanePatch> facets = facetsOfCylinder(cylinder);
  return facets.empty() ? Eigen::Vector4d(Eigen::Vector4d::Zero())
                        : facets[facets.size() / 2].coefficients;
}

} // namespace

MapDrawing::MapDrawing(const CompactMap& map,
                       const MapView& view,
                       const std::vector<Eigen::Vector3f>& others)
: map_(map)
, view_(view)
, hides_backs_(view.hide_backs || view.place != MapView::Place::Inside)
{
  requireSound(view);
  faces_ = facesOf(map);
  samples_ = samplesOf(faces_);
  frame_ = frameOf(map, samples_, view);
  std::vector<Eigen::Vector3f> shown = samples_;
  shown.insert(shown.end(), others.begin(), others.end());
  addPlaces(map.trajectory, shown);
  camera_ = placeMapCamera(map, faces_, shown, frame_, view);
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

std::vector<MapLine>
MapDrawing::linesOf(std::size_t surface) const
{
  if (!isDrawn(surface))
    return {};
  const std::size_t planes = map_.planes.size();
  return surface < planes ? outlinesOf(map_, surface) : rimOf(map_, surface - planes);
}

std::vector<MapLine>
MapDrawing::outlineLines() const
{
  std::vector<MapLine> lines;
  for (std::size_t i = 0; i < map_.planes.size() + map_.cylinders.size(); ++i)
    append(lines, linesOf(i));
  return lines;
}

Actors
MapDrawing::outlines() const
{
  return {actorOfOutlines(outlineLines())};
}

std::vector<SurfaceOutline>
MapDrawing::outlinesApart() const
{
  std::vector<SurfaceOutline> apart;
  for (std::size_t i = 0; i < map_.planes.size() + map_.cylinders.size(); ++i)
    if (const auto lines = linesOf(i); !lines.empty())
      apart.push_back({actorOfOutlines(lines),
                       i < map_.planes.size()
                           ? map_.planes[i].coefficients
                           : middleOf(map_.cylinders[i - map_.planes.size()])});
  return apart;
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

} // namespace pcl::acmap
