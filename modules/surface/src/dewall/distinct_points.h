#pragma once

#include "point_tree.h"

#include <pcl/core/point_view.h>
#include <pcl/surface/dewall_types.h>

namespace pcl::acmap::dewall {

/** \brief Returns the finite points of a view without repetitions: the first of equal
 * points is kept. The report's counts of skipped points are set. */
std::vector<SourcePoint>
distinctPoints(const PointView& view, DeWallReport& report);

} // namespace pcl::acmap::dewall
