#pragma once

#include <pcl/core/export.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref leaveWorstOut; see
 * registration::CorrespondenceRejectorWorstOut. */
struct WorstOutSettings {
  double most_distortion = 1.06; ///< largest D_ij (Eq. 1) of a match that stays
  double least_distance = 0.05;  ///< metres; shorter ones count as this
  std::size_t least_matches = 6; ///< fewer are none
  std::size_t sample = 1000;     ///< matches that Eq. 1 is a mean over, at most 1e6
};

/** \brief What \ref leaveWorstOut did. */
struct WorstOutOutcome {
  std::vector<std::int32_t> kept; ///< positions, rising; empty: no consistent set
  std::vector<std::int32_t>
      removed; ///< positions, in the order of their removal; all, where none is kept
  double distortion = 0; ///< largest D_ij of those kept
};

/** \brief Leaving the worst out: removes the match of the largest D_ij (Eq. 1; of equal
 * ones the first) again and again until none exceeds the bound. O(n^2) once, O(n) a
 * removal, O(n) memory. Pairs within the least distance in both clouds tell nothing; a
 * match that no pair tells about is removed. Above `sample` matches, evenly chosen ones
 * are cleaned, then judge the others.
 * \param[in] source, target as many points, metres; a match with a point that is not
 * finite is removed first */
ACMAP_EXPORT WorstOutOutcome
leaveWorstOut(const std::vector<Eigen::Vector3f>& source,
              const std::vector<Eigen::Vector3f>& target,
              const WorstOutSettings& settings);

} // namespace pcl::acmap
