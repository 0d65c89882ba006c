#pragma once

#include <pcl/Vertices.h>
#include <pcl/core/export.h>
#include <pcl/core/triangle_mesh.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief The polygons of a pcl::PolygonMesh as triangles: fans about their first corners.
 * Polygons of less than three corners are left out. \ingroup core */
ACMAP_EXPORT std::vector<TriangleMesh::Triangle>
trianglesOf(const std::vector<Vertices>& polygons);

/** \brief Lets a mesh pass whose corners are points of a cloud.
 * \param[in] points of the cloud
 * \throws InitFailedException naming a corner that is not */
ACMAP_EXPORT void
requireCornersInside(const std::vector<TriangleMesh::Triangle>& triangles,
                     std::size_t points);

} // namespace pcl::acmap
