#pragma once

#include <pcl/mapping/rectification_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief The paper's minimiser (II-B.2): random subsets of actions are changed, each in
 * proportion to its vote, which is what changing it did to the energy before. Eq. 3
 * alone; the energy never rises at a bin size. */
std::vector<PlanarPose>
votingSearch(const std::vector<LevelledPoints>& observations,
             const std::vector<PlanarPose>& poses,
             const RectificationSettings& settings,
             const Progress& progress,
             EntropyRectificationReport& report);

} // namespace pcl::acmap
