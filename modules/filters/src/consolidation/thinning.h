#pragma once

#include "consolidation/candidates.h"

namespace pcl::acmap {

/** \brief The candidates that are kept, and the replacements of the others. */
struct Thinning {
  LargeVector<std::uint32_t> kept; ///< indices of candidates, ascending

  /** For each candidate the index in \ref kept of itself or of the one that displaced
   * it. */
  PointLabels stand_in;
};

/** \brief Removes candidates closer than 0.7 edges (0.85 if they left their voxel) to
 * an earlier one on the same side. Candidates inside of their voxels come first, then
 * the others in the order of their displacement.
 * \param[in] candidates the candidates
 * \param[in] edge of a voxel, metres */
Thinning
thinOut(const LargeVector<Candidate>& candidates, double edge);

} // namespace pcl::acmap
