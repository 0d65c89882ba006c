#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/core/triangle_mesh.h>

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

/** \brief Unit cells by their lower corners. */
using Cells = std::set<std::pair<int, int>>;

/** \brief A random set of cells of a square, with holes, and with corners that touch. */
class CellRegion {
public:
  CellRegion(std::uint64_t seed, int side);

  /** \brief The rims of its connected parts, with the cells of each.
   * \param[in] pinched rims pass a corner twice where cells touch there, so that a rim
   * touches itself and takes in the holes that hang on it; otherwise such loops are
   * apart */
  std::vector<std::pair<PlanePolygon, Cells>>
  polygons(bool pinched) const;

private:
  Cells cells_;
};

/** \brief Places, a few a cell and around, that not just as many triangles cover as
 * should: one inside, none outside. */
int
wronglyCovered(const PlanePolygon& polygon,
               const Cells& cells,
               const std::vector<TriangleMesh::Triangle>& triangles);

} // namespace pcl::acmap::test
