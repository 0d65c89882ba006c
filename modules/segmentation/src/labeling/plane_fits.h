#pragma once

#include "labeling/plane_sums.h"

namespace pcl::acmap::labeling {

/** Moves each plane to its points, and its frame with them. Strips, and planes whose points
 * are on one line, keep the tilt that was guessed for them where the points do not know
 * better. */
void
fitPlanes(const std::vector<PlaneSums>& sums,
          const std::vector<Eigen::Vector3d>& guesses,
          std::vector<KnownPlane>& planes);

/** Puts the frame of each plane where its points are; the sums follow. */
void
centerFrames(std::vector<PlaneSums>& sums, std::vector<KnownPlane>& planes);

/** As \ref fitPlanes without the frames, with support, rms and covariance. */
void
finishPlanes(const std::vector<PlaneSums>& sums,
             const std::vector<Eigen::Vector3d>& guesses,
             std::vector<KnownPlane>& planes);

} // namespace pcl::acmap::labeling
