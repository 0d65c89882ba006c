#pragma once

#include <pcl/core/box_patch.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>

#include <vector>

namespace pcl {

/** \brief The sides of a box that were not seen and that no plane of the map bounds
 * (\ref BoxFaceKind::Free): they close it.
 *
 * A side is a plane with its area and one polygon of four corners, from which it can be
 * drawn as other planes are; its normal points out of the box.
 * \return in the order of the sides of a box; empty if the corners are no finite floats
 * \ingroup core */
ACMAP_EXPORT std::vector<PlanePatch>
freeSidesOf(const BoxPatch& box);

} // namespace pcl
