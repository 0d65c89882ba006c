#pragma once

#include "labeling/plane_sums.h"

namespace pcl::acmap::labeling {

/** Moves each plane to its points, and its frame with them. Strips keep the tilt that was
 * guessed for them where the points do not know better. */
void
fitPlanes(const std::vector<PlaneSums>& sums,
          const std::vector<Eigen::Vector3d>& guesses,
          std::vector<KnownPlane>& planes);

/** The same, with support, rms and covariance. */
void
finishPlanes(const std::vector<PlaneSums>& sums,
             const std::vector<Eigen::Vector3d>& guesses,
             std::vector<KnownPlane>& planes);

} // namespace pcl::acmap::labeling
