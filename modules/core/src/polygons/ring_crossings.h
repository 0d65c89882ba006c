#pragma once

#include "polygons/polygon_ring.h"

#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap {

/** \brief Selects the valid triangles of a polygon whose boundaries may cross. */
class RingCrossings {
public:
  /** \param[in] rings before their holes are bridged */
  explicit RingCrossings(const PolygonRings& rings);

  /** \brief Returns all triangles if no boundaries cross and the areas agree. Otherwise
   * returns those that no boundary passes through, that are inside, and that do not
   * overlap an earlier one, in O(n^2). */
  TriangleMesh::Triangles
  sound(TriangleMesh::Triangles triangles) const;

private:
  struct Edge {
    GridPoint from, to;
  };

  bool
  findCrossing() const;

  bool
  isWhole(const TriangleMesh::Triangles& triangles) const;

  bool
  isInside(const GridPoint (&corners)[3]) const;

  std::vector<Edge> edges_;               ///< sorted by their left ends
  std::vector<GridPoint> points_;         ///< of the polygon, by index
  __extension__ __int128 twice_area_ = 0; ///< of the outer boundary without the holes
  bool any_ = false;
};

} // namespace pcl::acmap
