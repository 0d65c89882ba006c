#pragma once

#include <pcl/texture/floor_plan.h>

#include <vector>

namespace pcl::acmap {

/** \brief Continues walls to the corner in which they meet, up to 2.5 m away, where neither end
 * is beside a wall or an opening: FloorPlan::unseen_walls. */
void
addHiddenCorners(FloorPlan& plan);

/** \brief Lines where a plan ends without a wall or an opening: where a wall was not seen, and
 * where the rooms end in the open. */
std::vector<std::vector<Eigen::Vector2d>>
unseenBordersOf(const FloorPlan& plan);

} // namespace pcl::acmap
