#pragma once

#include "camera.h"

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace pcl::acmap {

/** \brief An empty scene under lights and before a camera.
 * \param[in] light background, as surfaces want it; points would drown in light */
vtkSmartPointer<vtkRenderer>
makeStage(const Camera& camera, bool light);

/** \brief Light behind surfaces, dark behind points. */
void
setBackground(bool light, vtkRenderer* renderer);

/** \brief Puts the eye of a scene somewhere. */
void
setCamera(const Camera& camera, vtkRenderer* renderer);

} // namespace pcl::acmap
