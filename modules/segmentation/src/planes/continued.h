#pragma once

#include "planes/plane_merge.h"

namespace pcl::acmap::planes {

/** Joins regions that go on in one another along a border without a step, where one plane
 * takes both within what builders and sensors bend a surface by: a floor of 40 m is no
 * mirror, but it is one floor.
 * \return number of regions that were taken in */
std::size_t
joinContinued(const CellGraph& graph,
              const PlaneLimits& limits,
              double cosine,
              std::vector<GrownPlane>& planes);

} // namespace pcl::acmap::planes
