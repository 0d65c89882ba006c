#pragma once

#include "map_observations.h"

#include <optional>

namespace pcl::acmap {

/** \brief The normal of floors and ceilings, in the map and with y > 0: the direction that
 * most of the normals within 45 degrees of y share.
 * Nothing where few points have such a normal. */
std::optional<Eigen::Vector3d>
floorNormalOf(const MapObservations& observations);

} // namespace pcl::acmap
