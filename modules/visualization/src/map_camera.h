#pragma once

#include "camera.h"
#include "map_faces.h"

#include <pcl/visualization/map_snapshot.h>

namespace pcl::acmap {

/** \brief Directions of a building. */
struct MapFrame {
  Eigen::Vector3d up;
  Eigen::Vector3d along; ///< level, along walls, the way the map is longer
};

/** \param[in] samples points spread over the faces of the map */
MapFrame
frameOf(const CompactMap& map,
        const std::vector<Eigen::Vector3f>& samples,
        const SceneView& view);

/** \brief Where to look at a map from.
 * \throws BadArgumentException when the view has a size or a direction that cannot be */
Camera
placeMapCamera(const CompactMap& map,
               const std::vector<MapFaces>& faces,
               const std::vector<Eigen::Vector3f>& samples,
               const MapFrame& frame,
               const MapView& view);

} // namespace pcl::acmap
