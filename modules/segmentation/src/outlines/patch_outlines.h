#pragma once

#include "outlines/loop.h"
#include "planes/known_planes.h"

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

namespace outlines {

/** Converts loops to polygons and adds them to the patch, with their area: each hole is
 * assigned to the smallest rim around it. Small holes and islands of a few triangles
 * are artefacts of the mesh and are ignored. The loops may cross, because they were
 * moved onto lines and simplified independently.
 * \param[in] shaped in the patch's frame, metres
 * \param[in] min_area minimum area of a polygon or a hole, square metres
 * \param[in] spacing metres; points within a thousandth of it are merged */
void
setPolygons(const std::vector<Loop>& shaped,
            double min_area,
            double spacing,
            PlanePatch& patch);

} // namespace outlines

/** Sets the polygons of each plane: the boundaries of its mesh faces, moved onto the
 * intersection lines with its neighbours and simplified with a tolerance of one
 * spacing. Openings are kept. The area of the plane is set to that of the polygons. */
void
outlinePlanes(const std::vector<TriangleMesh::Triangle>& triangles, KnownPlanes& known);

} // namespace pcl::acmap
