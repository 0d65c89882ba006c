#pragma once

#include "camera.h"

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace pcl::acmap {

/** \brief An empty scene under lights and before a camera.
 * \param[in] light background, as surfaces want it; points would drown in light */
vtkSmartPointer<vtkRenderer>
makeStage(const Camera& camera, bool light);

} // namespace pcl::acmap
