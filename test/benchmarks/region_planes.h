#pragma once

#include "plane_finders.h"

#include <pcl/types.h>

namespace pcl::acmap::bench {

/** \brief Gives each region the plane of least squares through its points; what finds
 * regions tells no plane, or a rough one. */
FoundPlanes
planesOfRegions(const PlaneInput& input, const std::vector<Indices>& regions);

} // namespace pcl::acmap::bench
