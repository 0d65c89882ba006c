#pragma once

#include "entropy_search.h"

#include <vector>

namespace pcl::acmap {

/** \brief Descent on the direction-aware entropy with the odometry as prior, from short
 * windows to the whole map, coarse to fine, the entropy's weight from small to large.
 * Several searches are made until the rays (\ref RayEvidence) agree with one; where they
 * agree with none the poses stay. */
std::vector<PlanarPose>
guardedSearch(const RectificationTask& task,
              EntropySearch& search,
              const std::vector<PlanarPose>& poses);

} // namespace pcl::acmap
