#include "planes/plane_growth.h"

#include <cmath>

namespace pcl::acmap::planes {
namespace {

/** Adds one ring of points to a plane, in the order of its members; a point belongs to
 * the first plane that takes it. */
void
addRing(const CellGraph& graph,
        double distance,
        std::vector<std::uint8_t>& is_taken,
        GrownPlane& plane)
{
  const std::size_t before = plane.members.size();
  for (std::size_t m = 0; m < before; ++m)
    for (const std::int32_t other :
         graph.neighbours[static_cast<std::size_t>(plane.members[m])]) {
      const auto o = static_cast<std::size_t>(other);
      if (is_taken[o] || std::abs(plane.plane.distance(graph.points[o])) > distance)
        continue;
      is_taken[o] = 1;
      plane.members.push_back(other);
    }
}

} // namespace

void
widenRims(const CellGraph& graph, double distance, std::vector<GrownPlane>& planes)
{
  std::vector<std::uint8_t> is_taken(graph.size(), 0);
  for (const GrownPlane& plane : planes)
    for (const std::int32_t member : plane.members)
      is_taken[static_cast<std::size_t>(member)] = 1;
  constexpr int rings = 2;
  for (int ring = 0; ring < rings; ++ring)
    for (GrownPlane& plane : planes)
      if (plane.trust != PlaneTrust::Strip)
        addRing(graph, distance, is_taken, plane);
}

} // namespace pcl::acmap::planes
