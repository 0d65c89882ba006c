#pragma once

#include "planes/plane_merge.h"

namespace pcl::acmap::planes {

/** Merges adjacent regions without a step between them, if one plane fits both within
 * the usual bending of real surfaces and of sensor data: a floor of 40 m is not
 * perfectly flat, but it is one floor.
 * \return number of regions that were merged into others */
std::size_t
joinContinued(const CellGraph& graph,
              const PlaneLimits& limits,
              double cosine,
              std::vector<GrownPlane>& planes);

} // namespace pcl::acmap::planes
