#pragma once

#include "entropy_search.h"

#include <vector>

namespace pcl::acmap {

/** \brief The paper's minimiser (II-B.2): random subsets of actions are changed, each
 * in proportion to its vote, which is the effect of its previous changes on the energy.
 * It uses Eq. 3 alone; for each bin size the energy never increases. */
std::vector<PlanarPose>
votingSearch(const RectificationTask& task,
             EntropySearch& search,
             const std::vector<PlanarPose>& poses);

} // namespace pcl::acmap
