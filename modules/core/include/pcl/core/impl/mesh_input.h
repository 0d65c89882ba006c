#pragma once

#include <pcl/Vertices.h>
#include <pcl/core/export.h>
#include <pcl/core/triangle_mesh.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Converts the polygons of a pcl::PolygonMesh to triangles: fans about their
 * first corners. Polygons of fewer than three corners are omitted. \ingroup core */
ACMAP_EXPORT TriangleMesh::Triangles
trianglesOf(const std::vector<Vertices>& polygons);

/** \brief Checks that the corners of all triangles are points of a cloud.
 * \param[in] triangles the mesh
 * \param[in] points number of points of the cloud
 * \throws InitFailedException naming a corner that is out of range */
ACMAP_EXPORT void
requireCornersInside(const TriangleMesh::Triangles& triangles, std::size_t points);

} // namespace pcl::acmap
