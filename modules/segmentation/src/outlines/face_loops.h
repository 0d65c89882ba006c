#pragma once

#include <pcl/core/triangle_mesh.h>

#include <Eigen/Core>

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

/** Same as \ref faceLoops, for sorted edges that have the surface on their left. */
std::vector<std::vector<std::int32_t>>
edgeLoops(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
          const std::vector<Eigen::Vector2d>& places);

} // namespace pcl::acmap::outlines
