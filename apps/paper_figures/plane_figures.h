#pragma once

#include "figure_plan.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/output_folder.h>

namespace pcl::acmap {

/** \brief Draws fig8.png, the textured planes as the robot sees them with the planes
 * without texture on the top right, and fig9.png and fig10.png, from outside. */
void
drawPlanes(CompactMap map, const FigurePlan& plan, const OutputFolder& folder);

} // namespace pcl::acmap
