#pragma once

#include "camera.h"
#include "scene.h"

#include <pcl/visualization/mesh_snapshot.h>

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace pcl::acmap {

/** \brief Puts a scene under lights and before a camera.
 * \param[in] view what of it is drawn */
vtkSmartPointer<vtkRenderer>
makeRenderer(const Scene& scene, const Camera& camera, const SceneView& view);

} // namespace pcl::acmap
