#pragma once

#include <pcl/core/point_view.h>

namespace pcl::acmap {

/** \brief Estimates the edge in metres at which the occupied voxels of a cloud contain
 * the given number of points on average. It counts the voxels of a sample. Returns 0 if
 * the cloud has no extent. */
double
edgeForOccupancy(const PointView& points, double occupancy);

} // namespace pcl::acmap
