#pragma once

#include "camera.h"

#include <vtkRenderer.h>

#include <string>

namespace pcl::acmap {

/** \brief The largest of 1, 2, 5 times a power of ten that does not exceed a length. */
double
roundLength(double most);

/** \brief A length as text: "5 m", "20 cm", "2 km". */
std::string
lengthText(double metres);

/** \brief Adds a scale bar of a round length with its text at the lower left.
 * \param[in] camera an orthographic one */
void
addScaleBar(const Camera& camera, const SceneView& view, vtkRenderer* renderer);

} // namespace pcl::acmap
