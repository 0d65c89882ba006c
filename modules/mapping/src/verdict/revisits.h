#pragma once

#include "pose_draws.h"

#include <vector>

namespace pcl::acmap {

/** \brief Revisits of places that agree with the steps, and those that were not used. */
struct Revisits {
  std::vector<PoseLink> links; ///< two a revisit
  std::size_t used = 0;
  std::size_t ambiguous = 0; ///< others fit as well, or distinct places do
};

/** \brief Finds revisits by scans, in three rounds, from the certain ones to the others.
 * \param[in,out] drawn from the steps; then from steps and revisits */
Revisits
findRevisits(const std::vector<BeamScan>& scans,
             const StepChain& chain,
             std::uint64_t seed,
             PoseDraws& drawn);

} // namespace pcl::acmap
