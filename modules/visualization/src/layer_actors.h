#pragma once

#include "map_drawing.h"
#include "scene.h"

#include <pcl/visualization/layered_scene.h>

namespace pcl::acmap {

/** \brief A scene, its view, and the objects needed to draw it. */
struct LayerMaking {
  const LayeredScene& scene;
  const LayeredView& view;
  const MapDrawing* drawing; ///< null if there are no planes
  const Camera& camera;
};

/** \brief The cloud that is shown in the layer of the points. */
const PCLPointCloud2&
cloudOf(const LayeredScene& scene);

/** \brief Camera for a scene without planes. */
Camera
cameraOf(const LayeredScene& scene, const LayeredView& view);

Actors
actorsOfLayer(const LayerMaking& making, SceneLayer layer);

/** \brief The layer of the points or of the trajectory before rectification. */
Actors
actorsBefore(const LayerMaking& making, SceneLayer layer);

/** \brief The layer of the mesh at a step of the walls. */
Actors
actorsOfStep(const LayerMaking& making, std::size_t step);

} // namespace pcl::acmap
