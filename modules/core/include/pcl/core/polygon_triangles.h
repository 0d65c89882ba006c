#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/triangle_mesh.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {

/** \brief Triangulates a polygon with holes by ear clipping; its holes are connected to
 * the outer boundary by bridges (D. Eberly, Triangulation by Ear Clipping, 2002).
 *
 * Boundaries and holes may touch each other and themselves, contain duplicate points,
 * and have either orientation. Orientation tests are exact, on a grid of 2^-29 of the
 * polygon's extent. No points are added; points in the middle of a straight edge may be
 * without a triangle. Points that are not finite are skipped, loops without an area are
 * ignored. If loops cross, no triangulation without additional points exists and some
 * triangles are missing; the returned ones are inside and do not overlap. Holes outside
 * of the outer boundary are ignored. Time O(n^2), memory O(n).
 * \param[in] polygon metres
 * \param[in] normal of its plane, of any length
 * \return corners, counter-clockwise seen from the side to which the normal points.
 * They are indices into the points of the outer boundary followed by those of the
 * holes. Empty for a polygon without an area.
 * \throws BadArgumentException when the normal is zero or not finite. \ingroup core */
ACMAP_EXPORT TriangleMesh::Triangles
trianglesOfPolygon(const PlanePolygon& polygon, const Eigen::Vector3d& normal);

/** \brief Returns the points that these corners index: of the outer boundary, then of
 * the holes. \ingroup core */
ACMAP_EXPORT std::vector<Eigen::Vector3f>
pointsOfPolygon(const PlanePolygon& polygon);

} // namespace pcl
