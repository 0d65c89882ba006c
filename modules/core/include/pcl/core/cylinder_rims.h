#pragma once

#include <pcl/core/cylinder_patch.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief Makes planes and cylinders meet: where the boundary of a polygon runs round a
 * cylinder, it becomes the intersection of both.
 *
 * First, planes that the axis is parallel to: where the arc of a cylinder ends within the
 * tolerance of such a plane, and an edge of a polygon runs along there, both end in their
 * common line, as a curved wall and the flat one beside it do. Points that other planes
 * have too move with the edge.
 *
 * Points of a boundary within the tolerance of a cylinder are replaced by points of the
 * intersection, an ellipse, at the directions in which the facets of the cylinder begin
 * (\ref facetsOfCylinder), and the edges between them are of kind \ref EdgeKind::Arc. Creases
 * and contacts of two planes stay. A cylinder that ends within three tolerances of a plane
 * at a right angle to its axis ends on it afterwards, as a column does on the floor. What
 * would make a polygon cross itself is left as it is.
 *
 * Planes that the axis meets at 3 to 12 degrees are not changed.
 * \param[in] tolerance metres; at most half of the radius counts
 * \param[in,out] planes areas are those of the new polygons
 * \return number of arcs and lines
 * \throws BadArgumentException unless the tolerance is within [0, 1e9]. \ingroup core */
ACMAP_EXPORT std::size_t
joinAtCylinders(double tolerance,
                std::vector<CylinderPatch>& cylinders,
                std::vector<PlanePatch>& planes);

} // namespace pcl
