#include "planes/known_planes.h"

#include <algorithm>
#include <numeric>

namespace pcl::acmap::planes {

void
sortByArea(PlaneClusters& clusters)
{
  std::vector<std::int32_t> order(clusters.patches.size()), numbers(order.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return clusters.patches[static_cast<std::size_t>(a)].area >
           clusters.patches[static_cast<std::size_t>(b)].area;
  });
  std::vector<PlanePatch> sorted;
  for (const std::int32_t patch : order) {
    numbers[static_cast<std::size_t>(patch)] = static_cast<std::int32_t>(sorted.size());
    sorted.push_back(std::move(clusters.patches[static_cast<std::size_t>(patch)]));
  }
  clusters.patches = std::move(sorted);
  for (PlanePatch& patch : clusters.patches)
    for (PlanePolygon& polygon : patch.polygons)
      for (PolygonEdge& edge : polygon.edges)
        if (edge.neighbour >= 0)
          edge.neighbour = numbers[static_cast<std::size_t>(edge.neighbour)];
  const auto renumber = [&](std::int32_t& label) {
    label = label < 0 ? -1 : numbers[static_cast<std::size_t>(label)];
  };
  std::for_each(clusters.labels.begin(), clusters.labels.end(), renumber);
  std::for_each(clusters.source_labels.begin(), clusters.source_labels.end(), renumber);
}

} // namespace pcl::acmap::planes
