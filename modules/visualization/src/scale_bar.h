#pragma once

#include "camera.h"

#include <vtkRenderer.h>

#include <string>

namespace pcl::acmap {

/** \brief The largest of 1, 2, 5 times a power of ten that is not above a length. */
double
roundLength(double most);

/** \brief A length as text: "5 m", "20 cm", "2 km". */
std::string
lengthText(double metres);

/** \brief Puts a bar of a round length at the lower left, with its text.
 * \param[in] camera one without perspective */
void
addScaleBar(const Camera& camera, const SceneView& view, vtkRenderer* renderer);

} // namespace pcl::acmap
