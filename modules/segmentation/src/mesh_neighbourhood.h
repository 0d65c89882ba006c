#pragma once

#include <pcl/core/impl/vertex_neighbours.h>

namespace pcl::acmap {

/** The neighbours of \ref growRegion: elements that share an edge of the mesh, or are
 * near if there is no mesh. */
class MeshNeighbourhood {
public:
  /** \param[in] neighbours must outlive this object */
  explicit MeshNeighbourhood(const VertexNeighbours& neighbours)
  : neighbours_(neighbours)
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

} // namespace pcl::acmap
