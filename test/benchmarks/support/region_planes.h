#pragma once

#include "plane_finders.h"

#include <pcl/types.h>

namespace pcl::acmap::bench {

/** \brief Fits a least-squares plane to the points of each region, because the region
 * methods return no plane or an inaccurate one. */
FoundPlanes
planesOfRegions(const PlaneInput& input, const std::vector<Indices>& regions);

} // namespace pcl::acmap::bench
