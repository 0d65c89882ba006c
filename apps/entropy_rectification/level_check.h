#pragma once

#include "map_observations.h"

#include <optional>

namespace pcl::acmap {

/** \brief How far floors and ceilings are off the map's xz plane, radians: the angle
 * between y and the direction that most of the normals within 45 degrees of it share.
 * Nothing where few points have such a normal. */
std::optional<double>
tiltOf(const MapObservations& observations);

} // namespace pcl::acmap
