#pragma once

#include "polygons/polygon_ring.h"

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

/** \brief Keeps the triangles of a polygon sound though its rims may cross. */
class RingCrossings {
public:
  /** \param[in] rings before their holes are bridged */
  explicit RingCrossings(const PolygonRings& rings);

  /** \brief All triangles where no rims cross and the areas agree. Else those that no rim
   * leads through, that lie inside, and that overlap none before them, in O(n^2). */
  std::vector<TriangleMesh::Triangle>
  sound(std::vector<TriangleMesh::Triangle> triangles) const;

private:
  struct Edge {
    GridPoint from, to;
  };

  bool
  findCrossing() const;

  bool
  isWhole(const std::vector<TriangleMesh::Triangle>& triangles) const;

  bool
  isInside(const GridPoint (&corners)[3]) const;

  std::vector<Edge> edges_;               ///< by their left ends
  std::vector<GridPoint> points_;         ///< of the polygon, by index
  __extension__ __int128 twice_area_ = 0; ///< of the rim without the holes
  bool any_ = false;
};

} // namespace pcl::acmap
