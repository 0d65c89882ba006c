#pragma once

#include "chain/egomotion_view.h"

#include <pcl/egomotion/egomotion_types.h>

#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Why there is no motion. */
struct EgomotionFailure {
  EgomotionOutcome outcome;
  std::string reason;
};

/** \brief Fewer matches, or keypoints, tell nothing. */
constexpr std::size_t least_features = 6;

/** \brief Is that enough for a motion to stand on? Among many look-alikes a few agree
 * by chance: less than ten must be half of all. */
bool
isAgreement(std::size_t inliers, std::size_t matches);

/** \brief Whether a view shows enough.
 * \param[in] name what to call it */
std::optional<EgomotionFailure>
failureOfView(const EgomotionView& view, const std::string& name);

/** \brief Whether a motion is one to believe: within reach, told in all directions, and
 * not denied by the surfaces.
 * \param[in] contradicted share of the surfaces */
std::optional<EgomotionFailure>
failureOfMotion(const EgomotionEstimate& estimate,
                double contradicted,
                const EgomotionSettings& settings);

} // namespace pcl::acmap
