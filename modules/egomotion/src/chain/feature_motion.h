#pragma once

#include "chain/feature_pairs.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief The motion of matched features. */
struct FeatureMotion {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  std::vector<std::size_t> inliers; ///< indices of the pairs
};

/** \brief Eq. 2 by conjugate gradient, with weights of 1 / sigma^2, then robust least
 * squares with full covariances. The second step is repeated from the motion with the
 * minimum sum of distances, and the better result is returned. */
FeatureMotion
featureMotion(const std::vector<FeaturePair>& pairs,
              MotionModel model,
              MotionSolver solver);

} // namespace pcl::acmap
