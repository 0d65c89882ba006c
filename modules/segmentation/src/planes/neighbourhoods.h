#pragma once

#include "planes/cell_graph.h"

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

} // namespace pcl::acmap::planes
