#pragma once

#include "range.h"
#include "size_constraint.h"

namespace pcl::acmap::dewall {

/** \brief Closes holes of few sides by the triangles that turn least, under the guard and
 * the size constraint; where one would turn too steeply the hole stays.
 *
 * In the whole of the points only holes at vertices of walls are looked at: the parts
 * have closed the others. */
void
closeSmallHoles(const SizeConstraint& size, GrowingMesh& mesh, const Range& range);

} // namespace pcl::acmap::dewall
