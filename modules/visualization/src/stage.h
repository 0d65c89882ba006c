#pragma once

#include "camera.h"

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace pcl::acmap {

/** \brief An empty scene with lights and a camera.
 * \param[in] light bright background, for surfaces; points need a dark one */
vtkSmartPointer<vtkRenderer>
makeStage(const Camera& camera, bool light);

/** \brief Sets a bright background for surfaces or a dark one for points. */
void
setBackground(bool light, vtkRenderer* renderer);

/** \brief Sets the camera of a renderer. */
void
setCamera(const Camera& camera, vtkRenderer* renderer);

} // namespace pcl::acmap
