#pragma once

#include "map_observations.h"

#include <optional>

namespace pcl::acmap {

/** \brief The normal of floors and ceilings in the map, with y > 0: the most frequent
 * direction among the normals within 45 degrees of y. Nothing if only few points have
 * such a normal. */
std::optional<Eigen::Vector3d>
floorNormalOf(const MapObservations& observations);

} // namespace pcl::acmap
