#pragma once

#include "outlines/sightings.h"

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

/** Sets the polygons of each plane from the evidence: where the surface was seen, and
 * where a sensor looked through. Planes that touch end at their common line, and decide
 * it once: the edge has the same vertices in both polygons. Each edge is told to be a
 * crease, a contact, a rim or a frontier (\ref EdgeKind). Nothing is closed where a
 * sensor looked through, and what was not seen is not filled, but proposed where the
 * outlines enclose it (\ref PlanePatch::proposed). The area of each plane is set to that
 * of its polygons.
 * \param[in] triangles mesh of the points
 * \param[in] sensors of the points; unknown: rims and frontiers cannot be told apart
 * \param[in] source of these points; empty: rims are those of the mesh
 * \return number of polygons that keep the corners of the evidence, because their
 * straightened edges would cross */
std::size_t
outlineFromEvidence(const TriangleMesh::Triangles& triangles,
                    const SensorView& sensors,
                    const LabeledSource& source,
                    KnownPlanes& known);

} // namespace pcl::acmap
