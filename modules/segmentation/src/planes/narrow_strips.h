#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** Is a region so narrow that its cells are the rounding of two edges? */
bool
isNarrow(const Moments& moments, double spacing);

/** Guesses the planes of narrow strips between larger ones, such as the reveal of a door:
 * along the strip and upright on its largest neighbour. The cells of a strip tell only
 * where it runs; whether the guess is right, the points will tell. */
void
raiseStrips(const CellGraph& graph, std::vector<GrownPlane>& planes);

} // namespace pcl::acmap::planes
