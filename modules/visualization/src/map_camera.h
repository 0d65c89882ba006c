#pragma once

#include "camera.h"
#include "map_faces.h"

#include <pcl/visualization/map_snapshot.h>

namespace pcl::acmap {

/** \brief Main directions of a building. */
struct MapFrame {
  Eigen::Vector3d up;
  Eigen::Vector3d along; ///< horizontal, along the walls, in the direction of the
                         ///< larger extent
};

/** \param[in] samples points distributed over the faces of the map */
MapFrame
frameOf(const CompactMap& map,
        const std::vector<Eigen::Vector3f>& samples,
        const SceneView& view);

/** \brief Chooses the camera for a map.
 * \throws BadArgumentException when the view has an invalid size or direction */
Camera
placeMapCamera(const CompactMap& map,
               const std::vector<MapFaces>& faces,
               const std::vector<Eigen::Vector3f>& samples,
               const MapFrame& frame,
               const MapView& view);

} // namespace pcl::acmap
