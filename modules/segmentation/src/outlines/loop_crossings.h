#pragma once

#include "outlines/loop.h"

namespace pcl::acmap::outlines {

/** Resolves intersections of loops that have a surface on their left: loops that cross
 * or touch themselves or another one are cut at the intersections, and replaced by the
 * boundaries of the area that they enclose. The results share complete vertices only.
 * Loops that keep the distance are unchanged.
 * \param[in] distance points within it are merged, metres; well above the rounding of
 * floats. The rounding of doubles is its lower limit. */
std::vector<Loop>
disentangled(const std::vector<Loop>& loops, double distance);

} // namespace pcl::acmap::outlines
