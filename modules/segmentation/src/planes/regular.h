#pragma once

#include "planes/known_planes.h"

namespace pcl::acmap::planes {

/** Result of \ref makeRegular. */
struct Regularity {
  std::size_t turned = 0;
  double largest_turn = 0; ///< radians
};

/** Rotates planes about their centres to be exactly parallel or perpendicular to larger
 * ones, by at most three standard deviations of their tilt and at most one degree. */
Regularity
makeRegular(std::vector<KnownPlane>& planes);

} // namespace pcl::acmap::planes
