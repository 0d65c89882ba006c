#pragma once

#include <pcl/egomotion/impl/log_polar_kernel.h>

namespace pcl::acmap {

/** \brief Score of a pair that is excluded by a gate. */
constexpr std::int32_t no_score = std::numeric_limits<std::int32_t>::lowest();

/** \brief Positions of patches, in the image and in space. */
struct PatchPlaces {
  std::vector<float> u, v;    ///< pixels
  std::vector<float> x, y, z; ///< metres; empty if the gate has no maximum distance
  std::vector<float> reach;   ///< metres; the sum over a pair is the maximum distance
};

/** \param[in] distance_per_metre added to the reach per metre from the sensor */
PatchPlaces
placesOf(const LogPolarPatches& patches,
         const std::vector<Eigen::Vector3f>& points,
         const MatchGate& gate,
         float distance_per_metre);

/** \brief Removes the scores of one patch whose pairs do not pass the gate.
 * \param[in,out] scores with the patches of the other side */
void
applyGate(const PatchPlaces& rows,
          std::size_t row,
          const PatchPlaces& columns,
          const MatchGate& gate,
          std::int32_t* scores);

} // namespace pcl::acmap
