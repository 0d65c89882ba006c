#pragma once

#include "boxes/box.h"

#include <pcl/core/plane_patch.h>

#include <vector>

namespace pcl::acmap::boxes {

/** Fits the pose of a box and the positions of its sides to the planes of the seen
 * sides, by their covariances, and to the given positions of the others. Moves the
 * origin to the center, and sets covariance and misfit. */
void
fitPose(const std::vector<PlanePatch>& planes, Box& box);

} // namespace pcl::acmap::boxes
