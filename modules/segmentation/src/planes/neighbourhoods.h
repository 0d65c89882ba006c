#pragma once

#include "planes/cell_graph.h"
#include "planes/radius_grid.h"

namespace pcl::acmap::planes {

/** Points that share an edge of the mesh, or are near if there is no mesh. */
class GraphNeighbourhood {
public:
  explicit GraphNeighbourhood(const CellGraph& graph)
  : neighbours_(graph.neighbours)
  {}

  template <typename Visit>
  void
  visit(std::int32_t element, const Visit& visit) const
  {
    for (const std::int32_t other : neighbours_[static_cast<std::size_t>(element)])
      visit(other);
  }

private:
  const VertexNeighbours& neighbours_;
};

/** Points within the paper's W_d. */
class RadiusNeighbourhood {
public:
  RadiusNeighbourhood(const CellGraph& graph, double radius)
  : points_(graph.points)
  , grid_(graph.points, radius)
  {}

  template <typename Visit>
  void
  visit(std::int32_t element, const Visit& visit) const
  {
    grid_.visitNear(points_[static_cast<std::size_t>(element)], visit);
  }

private:
  const std::vector<Eigen::Vector3d>& points_;
  RadiusGrid grid_;
};

} // namespace pcl::acmap::planes
