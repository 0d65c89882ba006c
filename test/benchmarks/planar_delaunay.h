#pragma once

#include <pcl/core/impl/point_view.h>

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief CGAL's 2D Delaunay triangulation of x and y, on one thread: an approximate
 * lower bound for 3D meshing methods.
 * \return number of triangles */
std::size_t
planarDelaunay(const PointView& points);

} // namespace pcl::acmap::bench
