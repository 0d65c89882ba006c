#pragma once

#include <pcl/core/triangle_mesh.h>

#include <Eigen/Core>

#include <functional>
#include <utility>
#include <vector>

namespace pcl::acmap::outlines {

/** Boundary loops of triangles in a plane, as vertex numbers. The surface is on their
 * left: outer loops are counter-clockwise, those of holes clockwise. At a vertex where
 * the surface touches itself, a loop stays on its side.
 * \param[in] triangles counter-clockwise in the plane
 * \param[in] places positions of all vertices in the plane */
std::vector<std::vector<std::int32_t>>
faceLoops(const TriangleMesh::Triangles& triangles,
          const std::vector<Eigen::Vector2d>& places);

/** Position of a vertex in the plane. */
using PlaceOfVertex = std::function<Eigen::Vector2d(std::int32_t)>;

/** Same as \ref faceLoops, for sorted edges that have the surface on their left.
 * \param[in] place is asked only where the surface touches itself */
std::vector<std::vector<std::int32_t>>
edgeLoops(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
          const PlaceOfVertex& place);

} // namespace pcl::acmap::outlines
