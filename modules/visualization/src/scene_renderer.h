#pragma once

#include "camera.h"
#include "scene.h"

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace pcl::acmap {

/** \brief Puts a scene under lights and before a camera. */
vtkSmartPointer<vtkRenderer>
makeRenderer(const Scene& scene, const Camera& camera, bool show_boundary);

} // namespace pcl::acmap
