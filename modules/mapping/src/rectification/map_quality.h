#pragma once

#include <pcl/mapping/rectification_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief Measures the sharpness of a map: its mean map entropy, and the variance of
 * the walls along the two main directions of the building. Both are computed for
 * neighbourhoods of 0.4 m in XZ. */
void
measureQuality(const std::vector<LevelledPoints>& observations,
               const std::vector<PlanarPose>& poses,
               MapEvidence& evidence);

} // namespace pcl::acmap
