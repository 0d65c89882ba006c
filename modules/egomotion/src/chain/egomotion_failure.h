#pragma once

#include "chain/egomotion_view.h"

#include <pcl/egomotion/egomotion_types.h>

#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Reason why there is no motion. */
struct EgomotionFailure {
  EgomotionOutcome outcome;
  std::string reason;
};

/** \brief Minimum number of matches or keypoints. */
constexpr std::size_t min_features = 6;

/** \brief Returns true if there are enough inliers for a motion. Among many similar
 * keypoints a few agree by chance: fewer than ten must be at least half of the matches.
 */
bool
isAgreement(std::size_t inliers, std::size_t matches);

/** \brief Returns the failure if a view does not contain enough, otherwise nothing.
 * \param[in] name of the view, for the reason
 * \param[in] needed minimum number of keypoints */
std::optional<EgomotionFailure>
failureOfView(const EgomotionView& view, const std::string& name, std::size_t needed);

/** \brief Returns the failure if a motion is not reliable, otherwise nothing: it must
 * be within the bounds, determined in all directions, and not contradicted by the
 * surfaces.
 * \param[in] contradicted share of the surface blocks */
std::optional<EgomotionFailure>
failureOfMotion(const EgomotionEstimate& estimate,
                double contradicted,
                const EgomotionSettings& settings);

/** \brief Share of the surface blocks of one view that contradict the other, among
 * those that can be compared: blocks that would be clearly in front of what the other
 * view saw there. Returns the larger of both shares; for a correct motion it is almost
 * 0. */
double
contradictedShare(const EgomotionView& source,
                  const EgomotionView& target,
                  const Eigen::Isometry3d& T_target_source);

} // namespace pcl::acmap
