#pragma once

#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief An edge of a map, between two of its vertices. \ingroup core */
struct MapEdge {
  std::array<std::int32_t, 2> vertices{-1, -1}; ///< ascending
  EdgeKind kind = EdgeKind::Open;

  /** \brief The plane whose polygon has the edge, and the other one of a crease or a
   * contact, or -1. Both polygons of a crease have it; the first plane is the one with
   * the lower number. */
  std::array<std::int32_t, 2> planes{-1, -1};
  std::int32_t cylinder = -1; ///< of an arc; otherwise -1
};

/** \brief A polygon of a plane by the vertices of its boundaries. \ingroup core */
struct MapFace {
  std::int32_t plane = -1;
  std::int32_t polygon = -1; ///< index in the plane
  std::vector<std::int32_t> outer;
  std::vector<std::vector<std::int32_t>> holes;
};

/** \brief The vertices, edges and faces of a map: what its polygons have in common, told
 * once. \ingroup core */
struct MapTopology {
  std::vector<Eigen::Vector3f> vertices; ///< metres, in the frame of the planes
  std::vector<MapEdge> edges;            ///< in ascending order of their vertices
  std::vector<MapFace> faces;            ///< in the order of the planes
};

/** \brief Finds what the polygons of planes have in common: points with the same
 * coordinates are one vertex, and edges between the same vertices are one edge. An edge
 * of two planes is a crease. Other edges have the kind that their polygon tells
 * (\ref PlanePolygon::edges), or are open.
 *
 * The time is O(n log n) for n points of polygons. \ingroup core */
ACMAP_EXPORT MapTopology
topologyOf(const std::vector<PlanePatch>& planes);

} // namespace pcl
