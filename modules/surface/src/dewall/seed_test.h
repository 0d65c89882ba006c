#pragma once

#include "size_constraint.h"

#include <array>

namespace pcl::acmap::dewall {

/** \brief May three unused points be the first triangle of a component? Its smallest
 * sphere must be empty, and of the triangulations of points on one circle it must belong
 * to the one that \ref isNearerApex grows, or two seeds would cross each other. */
bool
isFirstTriangle(const PointTree& tree,
                const SizeConstraint& size,
                const std::array<std::int32_t, 3>& corners);

} // namespace pcl::acmap::dewall
