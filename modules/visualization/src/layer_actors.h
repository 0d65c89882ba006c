#pragma once

#include "map_drawing.h"
#include "scene.h"

#include <pcl/visualization/layered_scene.h>

namespace pcl::acmap {

/** \brief A scene, how it is looked at, and with what. */
struct LayerMaking {
  const LayeredScene& scene;
  const LayeredView& view;
  const MapDrawing* drawing; ///< where there are planes
  const Camera& camera;
};

/** \brief The cloud that stands for the layer of the points. */
const PCLPointCloud2&
cloudOf(const LayeredScene& scene);

/** \brief Where to look at a scene without planes from. */
Camera
cameraOf(const LayeredScene& scene, const LayeredView& view);

Actors
actorsOfLayer(const LayerMaking& making, SceneLayer layer);

/** \brief The layer of the points, or of the trajectory, before rectification. */
Actors
actorsBefore(const LayerMaking& making, SceneLayer layer);

/** \brief The layer of the mesh at a step of its walls. */
Actors
actorsOfStep(const LayerMaking& making, std::size_t step);

} // namespace pcl::acmap
