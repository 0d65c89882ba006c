#pragma once

#include "plane_finders.h"

namespace pcl::acmap::bench {

/** \brief Region growing on points from the flattest ones on; each region is fitted by
 * least squares. Needs CGAL 5. */
FoundPlanes
cgalRegionPlanes(const PlaneInput& input);

/** \brief Efficient RANSAC (Schnabel 2007) for planes, from a fixed seed; what it assigns
 * to a plane is fitted by least squares, as the plane itself is that of three points. */
FoundPlanes
cgalRansacPlanes(const PlaneInput& input);

} // namespace pcl::acmap::bench
