#pragma once

#include "size_constraint.h"

#include <array>

namespace pcl::acmap::dewall {

/** \brief Can three unused points be the first triangle of a component? Its smallest
 * sphere has to be empty, and for cocircular points it has to belong to the
 * triangulation that results from \ref isNearerApex; otherwise triangles from two seeds
 * could intersect. */
bool
isFirstTriangle(const PointTree& tree,
                const SizeConstraint& size,
                const std::array<std::int32_t, 3>& corners);

} // namespace pcl::acmap::dewall
