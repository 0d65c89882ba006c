#pragma once

#include <pcl/core/point_view.h>

namespace pcl::acmap {

/** \brief Edge in metres at which the occupied voxels of a cloud hold so many points on
 * average, by counting those of a sample; 0 where the cloud has no extent. */
double
edgeForOccupancy(const PointView& points, double occupancy);

} // namespace pcl::acmap
