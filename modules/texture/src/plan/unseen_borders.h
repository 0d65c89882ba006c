#pragma once

#include <pcl/texture/floor_plan.h>

#include <vector>

namespace pcl::acmap {

/** \brief Lines where a plan ends without a wall or an opening: where a wall was not seen, and
 * where the rooms end in the open. */
std::vector<std::vector<Eigen::Vector2d>>
unseenBordersOf(const FloorPlan& plan);

} // namespace pcl::acmap
