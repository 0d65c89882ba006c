#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/triangle_mesh.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {

/** \brief Cuts a polygon with holes into triangles by ear clipping, its holes bridged to
 * the rim (D. Eberly, Triangulation by Ear Clipping, 2002).
 *
 * Rims and holes may touch each other and themselves, and repeat points; they may turn
 * either way. Signs are exact, on a grid of 2^-29 of the polygon's extent. No point is
 * added; points in the middle of a straight run may have no triangle. Points that are not
 * finite are passed over, loops without an area are no loops. Where rims cross, which no
 * triangulation without new points can follow, triangles are missing; those that are there
 * lie inside and do not overlap. Holes outside of the rim are left out.
 * Time O(n^2), memory O(n).
 * \param[in] polygon metres
 * \param[in] normal of its plane, of any length
 * \return corners, counter-clockwise seen from the side the normal points to; they count
 * the points of the rim, then those of the holes, in their order; empty for a polygon
 * without an area
 * \throws BadArgumentException when the normal is zero or not finite. \ingroup core */
ACMAP_EXPORT std::vector<TriangleMesh::Triangle>
trianglesOfPolygon(const PlanePolygon& polygon, const Eigen::Vector3d& normal);

/** \brief The points that those corners count: of the rim, then of the holes. \ingroup core
 */
ACMAP_EXPORT std::vector<Eigen::Vector3f>
pointsOfPolygon(const PlanePolygon& polygon);

} // namespace pcl
