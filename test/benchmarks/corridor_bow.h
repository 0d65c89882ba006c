#pragma once

#include "rectification_maps.h"

#include <vector>

namespace pcl::acmap::bench {

/** \brief Bending of a straight corridor along z: the angle between its walls in the
 * first and in the last third of the observations, degrees.
 * \param[in] map of the scene `corridor`; its true poses define which points belong to
 * the walls
 * \param[in] poses of its observations */
double
bowOf(const RectificationMap& map, const std::vector<PlanarPose>& poses);

} // namespace pcl::acmap::bench
