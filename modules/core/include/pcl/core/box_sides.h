#pragma once

#include <pcl/core/box_patch.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>

#include <vector>

namespace pcl {

/** \brief The sides of a box that were not seen and that no plane of the map bounds
 * (\ref BoxFaceKind::Free): they close it.
 *
 * A side is a plane with its area and one polygon, from which it can be drawn as other
 * planes are; its normal points out of the box. The polygon is a rectangle, of which the
 * slanted side of the box cuts a part.
 * \return in the order of the sides of a box, without those that the slanted side cuts
 * off; empty if the corners are no finite floats
 * \ingroup core */
ACMAP_EXPORT std::vector<PlanePatch>
freeSidesOf(const BoxPatch& box);

} // namespace pcl
