#pragma once

#include "rectification_maps.h"

#include <vector>

namespace pcl::acmap::bench {

/** \brief How much a straight corridor along z bends: the angle between its walls in the
 * first and in the last third of the observations, degrees.
 * \param[in] map of the scene `corridor`; which points are of the two walls is told by the
 * true poses
 * \param[in] poses of its observations */
double
bowOf(const RectificationMap& map, const std::vector<PlanarPose>& poses);

} // namespace pcl::acmap::bench
