#pragma once

#include "entropy_search.h"

#include <vector>

namespace pcl::acmap {

/** \brief The paper's minimiser (II-B.2): random subsets of actions are changed, each in
 * proportion to its vote, which is what changing it did to the energy before. Eq. 3
 * alone; the energy never rises at a bin size. */
std::vector<PlanarPose>
votingSearch(const RectificationTask& task,
             EntropySearch& search,
             const std::vector<PlanarPose>& poses);

} // namespace pcl::acmap
