#pragma once

#include <pcl/core/point_view.h>

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief CGAL's Delaunay triangulation of x and y alone, on one thread: what a mesher in
 * space can hardly undercut.
 * \return number of triangles */
std::size_t
planarDelaunay(const PointView& points);

} // namespace pcl::acmap::bench
