#pragma once

#include "range.h"
#include "size_constraint.h"

namespace pcl::acmap::dewall {

/** \brief Closes holes with few edges by the triangles with the smallest turns, under
 * the guard and the size constraint; a hole that needs too large a turn remains open.
 *
 * In the range of all points, only holes at vertices of walls are considered, as the
 * parts have closed the others. */
void
closeSmallHoles(const SizeConstraint& size, GrowingMesh& mesh, const Range& range);

} // namespace pcl::acmap::dewall
