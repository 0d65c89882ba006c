#pragma once

#include "planes/known_planes.h"

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

/** Gives each plane its polygons: the rims of the mesh's faces on it, drawn to the lines in
 * which it meets its neighbours, simplified within a spacing. Openings stay open. The area
 * is that of the polygons. */
void
outlinePlanes(const std::vector<TriangleMesh::Triangle>& triangles, KnownPlanes& known);

} // namespace pcl::acmap
