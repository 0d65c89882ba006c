#pragma once

#include <pcl/egomotion/log_polar_kernel.h>

namespace pcl::acmap {

/** \brief No score: of a pair that no gate lets pass. */
constexpr std::int32_t no_score = std::numeric_limits<std::int32_t>::lowest();

/** \brief Where patches lie, in the image and in space. */
struct PatchPlaces {
  std::vector<float> u, v;    ///< pixels
  std::vector<float> x, y, z; ///< metres; empty where no gate asks
  std::vector<float> reach;   ///< metres, their share of the distance allowed
};

/** \param[in] distance_per_metre added for each metre from the sensor */
PatchPlaces
placesOf(const LogPolarPatches& patches,
         const std::vector<Eigen::Vector3f>& points,
         const MatchGate& gate,
         float distance_per_metre);

/** \brief Takes the scores of one patch off that fail the gate.
 * \param[in,out] scores with those of the other side */
void
applyGate(const PatchPlaces& rows,
          std::size_t row,
          const PatchPlaces& columns,
          const MatchGate& gate,
          std::int32_t* scores);

} // namespace pcl::acmap
