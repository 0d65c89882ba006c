#include "map_pictures.h"

#include "memory.h"
#include "plane_extraction/plane_outputs.h"

#include <pcl/visualization/map_snapshot.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <utility>

namespace pcl::acmap {

void
savePictures(const OutputFolder& folder,
             const MappedPlanes& found,
             const CompactMap& map)
{
  const UnlimitedMemory while_drawing;
  saveSnapshot(
      folder.path("mesh.png"), found.vertices.cloud, found.mesh, sceneViewOf(found));
  savePicture(folder.path("planes.png"), found);
  const std::pair<const char*, MapView::Place> places[] = {
      {"outside.png", MapView::Place::Outside},
      {"inside.png", MapView::Place::Inside},
      {"floor_plan.png", MapView::Place::Plan}};
  for (const auto& [name, place] : places) {
    MapView map_view;
    map_view.place = place;
    saveMapSnapshot(folder.path(name), map, map_view);
  }
}

} // namespace pcl::acmap
