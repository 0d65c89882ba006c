#pragma once

#include "figure_inputs.h"
#include "figure_plan.h"

#include <pcl/core/output_folder.h>

namespace pcl::acmap {

/** \brief Draws fig4.png: the true plan, the map's points from above before and after
 * rectification with the true plan, and perspective views of the points after it. */
void
drawMapFigure(const FilmedSession& session,
              const MappedSession& map,
              const FigurePlan& plan,
              const OutputFolder& folder);

} // namespace pcl::acmap
