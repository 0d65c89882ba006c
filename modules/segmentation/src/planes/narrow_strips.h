#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** Is a region so narrow that its hypotheses may only be two rounded edges? */
bool
isNarrow(const Moments& moments, double spacing);

/** Guesses the planes of narrow strips between larger ones, such as the reveal of a
 * door: along the strip and perpendicular to its largest neighbour. The hypotheses of a
 * strip determine its direction only; whether the guess is right is verified with the
 * points later. */
void
raiseStrips(const CellGraph& graph, std::vector<GrownPlane>& planes);

} // namespace pcl::acmap::planes
