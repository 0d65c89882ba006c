#pragma once

#include "outlines/loop.h"
#include "planes/known_planes.h"

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

namespace outlines {

/** Loops as polygons: each hole in the least rim around it. Holes and islands of a few
 * triangles are what the mesh happened to miss or to catch. Loops that were drawn to lines
 * and simplified each on its own may cross.
 * Adds to the patch's polygons and area.
 * \param[in] shaped in the patch's frame, metres
 * \param[in] least_area of a polygon or a hole, square metres
 * \param[in] spacing metres; points a thousandth of it apart meet */
void
setPolygons(const std::vector<Loop>& shaped,
            double least_area,
            double spacing,
            PlanePatch& patch);

} // namespace outlines

/** Gives each plane its polygons: the rims of the mesh's faces on it, drawn to the lines in
 * which it meets its neighbours, simplified within a spacing. Openings stay open. The area
 * is that of the polygons. */
void
outlinePlanes(const std::vector<TriangleMesh::Triangle>& triangles, KnownPlanes& known);

} // namespace pcl::acmap
