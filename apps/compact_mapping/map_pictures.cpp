#include "map_pictures.h"

#include "memory.h"
#include "plane_extraction/plane_outputs.h"

#include <pcl/visualization/map_snapshot.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <utility>

namespace pcl::acmap {

void
savePictures(const OutputFolder& folder,
             const Extraction& extraction,
             const CompactMap& map)
{
  const UnlimitedMemory while_drawing;
  const HypothesisMesh& mesh = extraction.mesh;
  saveSnapshot(
      folder.path("mesh.png"), mesh.vertices.cloud, mesh.mesh, sceneViewOf(mesh));
  savePicture(folder.path("planes.png"), mesh, extraction.clusters.labels);
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
