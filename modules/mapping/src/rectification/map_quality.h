#pragma once

#include <pcl/mapping/rectification_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief How sharp a map is: its mean map entropy, and the variance of its walls that lie
 * along the building's two main directions. Both over neighbourhoods of 0.4 m in XZ. */
void
measureQuality(const std::vector<LevelledPoints>& observations,
               const std::vector<PlanarPose>& poses,
               MapEvidence& evidence);

} // namespace pcl::acmap
