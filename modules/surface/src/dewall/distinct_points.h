#pragma once

#include "point_tree.h"

#include <pcl/core/point_view.h>
#include <pcl/surface/dewall_types.h>

namespace pcl::acmap::dewall {

/** \brief The finite points of a view without repetitions: of equal ones the first
 * stays. Fills the report's counts of points left out. */
std::vector<SourcePoint>
distinctPoints(const PointView& view, DeWallReport& report);

} // namespace pcl::acmap::dewall
