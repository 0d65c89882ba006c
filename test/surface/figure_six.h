#pragma once

#include "mesh_checker.h"

namespace pcl::acmap::test {

/** \brief Fig. 6 of the paper by brute force: connected clusters, then Triange_Builder for
 * each of them, which tests all points at every step.
 *
 * It shares no code with the product. Doubles have to be exact enough: either the points
 * are in general position, or their coordinates are small integers.
 * \param[in] longest size constraint
 * \param[in] leaf_size a part of at most this number of points has no splitting plane
 * \return the triangles as sorted sets of vertices */
Triangles
figureSix(const Points& points, double longest, std::size_t leaf_size);

} // namespace pcl::acmap::test
