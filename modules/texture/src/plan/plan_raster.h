#pragma once

#include "plan/plan_drawing.h"

#include <pcl/core/image_file.h>

namespace pcl::acmap {

/** \brief Draws on an image, with smooth edges; needs no display.
 * \param[in] resolution pixels for a millimetre of the paper */
RgbImage
rasterOf(const PlanDrawing& drawing, double resolution);

} // namespace pcl::acmap
