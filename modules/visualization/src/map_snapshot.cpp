#include <pcl/visualization/display_connection.h>
#include <pcl/visualization/map_snapshot.h>

#include "map_drawing.h"
#include "picture.h"

namespace pcl {
namespace {

acmap::Actors
actorsOf(const acmap::MapDrawing& drawing, MapView::Paint paint)
{
  switch (paint) {
  case MapView::Paint::PlaneColors:
    return drawing.planes(1);
  case MapView::Paint::Outlines:
    return drawing.outlines();
  case MapView::Paint::Textured:
    break;
  }
  return drawing.textures();
}

} // namespace

void
saveMapSnapshot(const std::string& path, const CompactMap& map, const MapView& view)
{
  const acmap::DisplayConnection display;
  const acmap::MapDrawing drawing(map, view);
  const auto renderer = acmap::makeStage(drawing.camera());
  for (const auto& actor : actorsOf(drawing, view.paint))
    renderer->AddActor(actor);
  drawing.addPlanTo(renderer);
  acmap::savePicture(path, renderer, view);
}

} // namespace pcl
