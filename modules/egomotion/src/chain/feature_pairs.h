#pragma once

#include "chain/egomotion_view.h"
#include "chain/evidence.h"

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap {

/** \brief A point that both views saw, with what each place is worth. */
struct FeaturePair {
  std::int32_t source_pixel, target_pixel;              ///< of the views
  Eigen::Vector3d source, target;                       ///< metres
  Eigen::Matrix3d source_covariance, target_covariance; ///< m^2
};

/** \brief The pair of two keypoints: sigma along the ray, half a pixel of the level
 * across. */
FeaturePair
featurePair(const EgomotionView& source,
            const EgomotionView& target,
            std::size_t level,
            const PatchMatch& match);

/** \brief Squared distance under a motion, in standard deviations. */
double
squaredDistance(const FeaturePair& pair, const Eigen::Isometry3d& T_target_source);

/** \brief Eq. 2 with each pair's full covariance in place of B_ij, robust. */
Evidence
featureTerm(const std::vector<FeaturePair>& pairs,
            const Eigen::Isometry3d& T_target_source);

} // namespace pcl::acmap
