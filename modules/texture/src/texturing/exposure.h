#pragma once

#include "texturing/canvas.h"

#include <vector>

namespace pcl::acmap::texturing {

/** Factors, one a view, that make the views agree where they saw the same texels: least
 * squares of the logarithms of their brightness, near 1 as a whole and for views that share
 * nothing. Brightness that is clipped says nothing. */
std::vector<double>
exposureGains(const std::vector<Canvas>& canvases, std::size_t views);

} // namespace pcl::acmap::texturing
