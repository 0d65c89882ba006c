#pragma once

#include "planes/cell_graph.h"

namespace pcl::acmap::planes {

/** Returns the members whose mesh neighbours are all in the same region: they are
 * neither at its rim nor in a strip that is too narrow to define a plane. */
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
