#pragma once

#include "consolidation/candidates.h"

#include <vector>

namespace pcl::acmap {

/** \brief Which candidates stay, and who stands for the others. */
struct Thinning {
  std::vector<std::uint32_t> kept; ///< candidates, ascending

  /** For each candidate the position in \ref kept of itself or of who displaced it. */
  std::vector<std::int32_t> stand_in;
};

/** \brief Drops candidates nearer to an earlier one on the same side than 0.7 edges,
 * or 0.85 when they strayed: those that stayed in their voxel come first, then the others
 * by how far they strayed.
 * \param[in] edge of a voxel, metres */
Thinning
thinOut(const std::vector<Candidate>& candidates, double edge);

} // namespace pcl::acmap
