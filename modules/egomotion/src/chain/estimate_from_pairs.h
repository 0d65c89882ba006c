#pragma once

#include "chain/egomotion_view.h"
#include "chain/feature_pairs.h"

#include <pcl/egomotion/impl/egomotion_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief Same as \ref estimateEgomotion, with matches that were found elsewhere.
 * \param[in] pairs of similar appearance; the views need no features */
EgomotionSolution
estimateFromPairs(const EgomotionView& source,
                  const EgomotionView& target,
                  const std::vector<FeaturePair>& pairs,
                  const EgomotionSettings& settings,
                  EgomotionReport& report);

} // namespace pcl::acmap
