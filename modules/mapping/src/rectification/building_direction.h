#pragma once

#include <pcl/mapping/map_entropy_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief The turn about y that lays a building along the axes: where H(q_X) + H(q_Z) of
 * Eq. 3 is least, in [0, pi / 2), within a twentieth of a degree. */
double
buildingDirection(const std::vector<EntropyCells>& observations,
                  const std::vector<PlanarPose>& poses,
                  const MapEntropySettings& settings);

/** \brief Poses in a map that is turned about y. */
std::vector<PlanarPose>
turnedMap(const std::vector<PlanarPose>& poses, double turn);

} // namespace pcl::acmap
