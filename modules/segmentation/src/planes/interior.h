#pragma once

#include "planes/cell_graph.h"

namespace pcl::acmap::planes {

/** Those members all of whose neighbours in the mesh are of the region too: neither at its
 * rim nor in a strip too narrow to have a plane of its own. */
inline std::vector<std::int32_t>
interior(const CellGraph& graph,
         const std::vector<std::int32_t>& members,
         const std::vector<std::int32_t>& owner)
{
  std::vector<std::int32_t> inner;
  for (const std::int32_t member : members) {
    const auto m = static_cast<std::size_t>(member);
    bool is_inner = graph.neighbours[m].size() > 0;
    for (const std::int32_t other : graph.neighbours[m])
      is_inner &= owner[static_cast<std::size_t>(other)] == owner[m];
    if (is_inner)
      inner.push_back(member);
  }
  return inner;
}

} // namespace pcl::acmap::planes
