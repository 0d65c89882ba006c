#pragma once

#include "texturing/canvas.h"

#include <pcl/texture/texturing_kernel.h>

namespace pcl::acmap::texturing {

/** For each point of a view the canvas that it colours, -1 for none: the one of the closest
 * plane, on its seen side, whose polygon the point's foot is in (the paper's last step). */
std::vector<std::int32_t>
nearestCanvases(const ColoredView& view,
                const std::vector<PlanePatch>& planes,
                const std::vector<Canvas>& canvases,
                double maximum_distance);

} // namespace pcl::acmap::texturing
