#pragma once

#include "chain/feature_pairs.h"

#include <pcl/egomotion/impl/revisit_kernel.h>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Do enough of the keypoints agree on a rigid motion (Eq. 1), and are they spread
 * so far that they tell the place from others? */
bool
areConsistent(const std::vector<FeaturePair>& alike);

/** \brief Verifies by egomotion and by the surfaces that two views see the same place.
 * \return the revisit, without the numbers of its views */
std::optional<Revisit>
verifyRevisit(CameraView later,
              CameraView earlier,
              const std::vector<FeaturePair>& alike);

} // namespace pcl::acmap
