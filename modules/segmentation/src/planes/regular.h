#pragma once

#include "planes/known_planes.h"

namespace pcl::acmap::planes {

/** What \ref makeRegular did. */
struct Regularity {
  std::size_t turned = 0;
  double largest_turn = 0; ///< radians
};

/** Turns planes about their centres to be exactly parallel or at right angles to larger
 * ones, as far as their own uncertainty allows: three standard deviations, a degree at
 * most. */
Regularity
makeRegular(std::vector<KnownPlane>& planes);

} // namespace pcl::acmap::planes
