#pragma once

#include "chain/feature_pairs.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief The motion of matched features. */
struct FeatureMotion {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  std::vector<std::size_t> inliers; ///< positions among the pairs
};

/** \brief Eq. 2 by conjugate gradient, each pair weighted by 1 / sigma^2, then, with
 * full covariances, by robust least squares. */
FeatureMotion
featureMotion(const std::vector<FeaturePair>& pairs,
              MotionModel model,
              MotionSolver solver);

} // namespace pcl::acmap
