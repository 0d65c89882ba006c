#pragma once

#include <pcl/mapping/map_entropy_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief The rotation about y that aligns a building with the axes: the angle in [0,
 * pi / 2) with the minimum of H(q_X) + H(q_Z) of Eq. 3, within a twentieth of a
 * degree. */
double
buildingDirection(const std::vector<EntropyCells>& observations,
                  const std::vector<PlanarPose>& poses,
                  const MapEntropySettings& settings);

/** \brief Returns the poses in a map that is rotated about y. */
std::vector<PlanarPose>
turnedMap(const std::vector<PlanarPose>& poses, double turn);

} // namespace pcl::acmap
