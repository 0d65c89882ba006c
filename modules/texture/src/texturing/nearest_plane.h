#pragma once

#include "texturing/canvas.h"

#include <pcl/texture/texturing_kernel.h>

namespace pcl::acmap::texturing {

/** For each point of a view, the canvas that it colours, or -1: the canvas of the
 * closest plane that faces the sensor and whose polygon contains the projection of the
 * point (the last step of the paper). */
std::vector<std::int32_t>
nearestCanvases(const ColoredView& view,
                const std::vector<PlanePatch>& planes,
                const std::vector<Canvas>& canvases,
                double maximum_distance);

} // namespace pcl::acmap::texturing
