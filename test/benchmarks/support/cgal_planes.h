#pragma once

#include "plane_finders.h"

namespace pcl::acmap::bench {

/** \brief Region growing on points, starting at the flattest ones; each region is
 * fitted by least squares. Needs CGAL 5. */
FoundPlanes
cgalRegionPlanes(const PlaneInput& input);

/** \brief Efficient RANSAC (Schnabel 2007) for planes, with a fixed seed. The points of
 * each plane are fitted by least squares, as the plane itself is defined by three
 * points. */
FoundPlanes
cgalRansacPlanes(const PlaneInput& input);

} // namespace pcl::acmap::bench
