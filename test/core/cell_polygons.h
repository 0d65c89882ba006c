#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/core/triangle_mesh.h>

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

/** \brief Unit cells, given by their lower corners. */
using Cells = std::set<std::pair<int, int>>;

/** \brief A random set of cells of a square, with holes and touching corners. */
class CellRegion {
public:
  CellRegion(std::uint64_t seed, int side);

  /** \brief The polygons of its connected components, with the cells of each.
   * \param[in] pinched loops pass through a corner twice if cells touch there, so that
   * an outline touches itself and contains the holes connected to it; otherwise such
   * loops are separate */
  std::vector<std::pair<PlanePolygon, Cells>>
  polygons(bool pinched) const;

private:
  Cells cells_;
};

/** \brief Number of sample positions (a few per cell, and around) with a wrong number
 * of covering triangles: it should be one inside and none outside. */
int
wronglyCovered(const PlanePolygon& polygon,
               const Cells& cells,
               const TriangleMesh::Triangles& triangles);

} // namespace pcl::acmap::test
