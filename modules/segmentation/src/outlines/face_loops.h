#pragma once

#include <pcl/core/triangle_mesh.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace pcl::acmap::outlines {

/** Rims of some triangles in a plane, as vertices: the surface on their left, so that
 * outer rims run counter-clockwise and those of holes clockwise. Where the surface touches
 * itself in a vertex, a rim stays with its side.
 * \param[in] triangles counter-clockwise in the plane
 * \param[in] places of all vertices in the plane */
std::vector<std::vector<std::int32_t>>
faceLoops(const std::vector<TriangleMesh::Triangle>& triangles,
          const std::vector<Eigen::Vector2d>& places);

/** The same of edges, sorted, that have the surface on their left. */
std::vector<std::vector<std::int32_t>>
edgeLoops(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
          const std::vector<Eigen::Vector2d>& places);

} // namespace pcl::acmap::outlines
