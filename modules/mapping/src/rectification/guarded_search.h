#pragma once

#include "entropy_search.h"

#include <vector>

namespace pcl::acmap {

/** \brief Descent on the direction-aware entropy with the odometry as prior, from short
 * windows to the whole map, from coarse to fine, with increasing weight of the entropy.
 * Several searches are made until the rays (\ref RayEvidence) support one of them; if
 * they support none, the poses are unchanged. */
std::vector<PlanarPose>
guardedSearch(const RectificationTask& task,
              EntropySearch& search,
              const std::vector<PlanarPose>& poses);

} // namespace pcl::acmap
