#pragma once

#include "chain/feature_pairs.h"

#include <vector>

namespace pcl::acmap {

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
