#pragma once

#include "labeling/candidate_grid.h"

namespace pcl::acmap::labeling {

/** Gives hypotheses of no plane, as those at creases, whose normals are mixed, to the plane
 * near them that they lie on.
 * \param[in] distance metres */
void
gatherStragglers(double distance, const CandidateGrid& grid, KnownPlanes& known);

} // namespace pcl::acmap::labeling
