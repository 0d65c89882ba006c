#pragma once

#include "chain/feature_pairs.h"

#include <pcl/egomotion/impl/revisit_kernel.h>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief The keypoints among \a alike that agree on a rigid motion; none if they are
 * too few or too close together to distinguish the place from others. */
std::vector<FeaturePair>
agreeingPairs(const std::vector<FeaturePair>& alike);

/** \brief Verifies by egomotion and by the surfaces that two views see the same place.
 * \return the revisit, without the numbers of its views */
std::optional<Revisit>
verifyRevisit(CameraView later,
              CameraView earlier,
              const std::vector<FeaturePair>& alike);

} // namespace pcl::acmap
