#pragma once

#include "chain/egomotion_view.h"
#include "chain/evidence.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief A point seen in both views, with its covariances. */
struct FeaturePair {
  std::int32_t source_pixel, target_pixel;              ///< in the views
  Eigen::Vector3d source, target;                       ///< metres
  Eigen::Matrix3d source_covariance, target_covariance; ///< m^2
};

/** \brief Covariance of a keypoint, m^2: sigma along the ray, and half a pixel of the
 * scale across.
 * \param[in] place metres, camera frame
 * \param[in] sigma metres
 * \param[in] scale size of a pixel of the keypoint's level in pixels of the view */
Eigen::Matrix3d
placeCovariance(const Eigen::Vector3d& place,
                double sigma,
                double scale,
                const std::optional<Pinhole>& pinhole);

/** \brief The pair of two keypoints; the covariance has sigma along the ray, and half a
 * pixel of the level across. */
FeaturePair
featurePair(const EgomotionView& source,
            const EgomotionView& target,
            std::size_t level,
            const PatchMatch& match);

/** \brief Squared distance after a motion, in standard deviations. */
double
squaredDistance(const FeaturePair& pair, const Eigen::Isometry3d& T_target_source);

/** \brief Eq. 2 with the full covariance of each pair in place of B_ij, robust.
 * \param[in] target_pinhole of the tiles of the gradients; without it all are in one */
Evidence
featureTerm(const std::vector<FeaturePair>& pairs,
            const Eigen::Isometry3d& T_target_source,
            const Pinhole* target_pinhole = nullptr);

/** \brief Pairs of keypoints of two views with a similar appearance, at all levels. */
std::vector<FeaturePair>
alikePairs(const EgomotionView& source,
           const EgomotionView& target,
           const EgomotionSettings& settings);

/** \brief Selects the pairs that agree on a rigid motion (Eq. 1). */
std::vector<FeaturePair>
consistentPairs(const std::vector<FeaturePair>& pairs,
                const WorstOutSettings& settings);

} // namespace pcl::acmap
