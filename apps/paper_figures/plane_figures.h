#pragma once

#include "figure_plan.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/output_folder.h>

namespace pcl::acmap {

/** \brief Draws fig8.png, the textured planes as seen by the robot with the planes
 * without texture in the upper right corner, and fig9.png and fig10.png, from
 * outside. */
void
drawPlanes(CompactMap map, const FigurePlan& plan, const OutputFolder& folder);

} // namespace pcl::acmap
