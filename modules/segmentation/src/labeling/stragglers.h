#pragma once

#include "labeling/candidate_grid.h"

namespace pcl::acmap::labeling {

/** Assigns hypotheses without a plane to the nearest plane within a distance. Such
 * hypotheses are often at creases, where normals are mixed.
 * \param[in] distance metres */
void
gatherStragglers(double distance, const CandidateGrid& grid, KnownPlanes& known);

} // namespace pcl::acmap::labeling
