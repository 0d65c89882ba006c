#pragma once

#include "labeling/plane_sums.h"

namespace pcl::acmap::labeling {

/** Fits each plane to its points and updates its frame. Strips, and planes whose points
 * are on one line, keep their guessed tilt unless the points determine it better. */
void
fitPlanes(const std::vector<PlaneSums>& sums,
          const std::vector<Eigen::Vector3d>& guesses,
          std::vector<KnownPlane>& planes);

/** Moves the frame of each plane to its points and transforms the sums accordingly. */
void
centerFrames(std::vector<PlaneSums>& sums, std::vector<KnownPlane>& planes);

/** Same as \ref fitPlanes, but sets support, rms and covariance instead of the
 * frames. */
void
finishPlanes(const std::vector<PlaneSums>& sums,
             const std::vector<Eigen::Vector3d>& guesses,
             std::vector<KnownPlane>& planes);

} // namespace pcl::acmap::labeling
