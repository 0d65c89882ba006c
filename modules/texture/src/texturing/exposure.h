#pragma once

#include "texturing/canvas.h"

#include <vector>

namespace pcl::acmap::texturing {

/** Exposure gains, one per view, for which the views agree on the texels that they
 * share: the least-squares solution in the logarithms of the brightness, with a prior
 * that keeps the gains near 1; views without shared texels get 1. Clipped samples are
 * ignored. */
std::vector<double>
exposureGains(const std::vector<Canvas>& canvases, std::size_t views);

} // namespace pcl::acmap::texturing
