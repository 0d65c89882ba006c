#include "planes/replaced_planes.h"

#include <utility>

namespace pcl::acmap {

namespace {

constexpr std::int32_t removed = -1;

/** For each plane its number without the replaced ones, or removed. */
std::vector<std::int32_t>
numbersWithout(std::vector<CylinderPatch>& cylinders, std::size_t planes)
{
  std::vector<std::int32_t> numbers(planes, 0);
  for (CylinderPatch& cylinder : cylinders) {
    for (const std::int32_t plane : cylinder.planes)
      numbers[static_cast<std::size_t>(plane)] = removed;
    cylinder.planes.clear();
  }
  std::int32_t next = 0;
  for (std::int32_t& number : numbers)
    if (number != removed)
      number = next++;
  return numbers;
}

template <typename Labels>
void
renumberAll(const std::vector<std::int32_t>& numbers, Labels& labels)
{
  for (std::int32_t& label : labels)
    if (label >= 0)
      label = numbers[static_cast<std::size_t>(label)];
}

/** An edge whose neighbour is removed is open: what is beyond it is no plane. */
void
renumber(const std::vector<std::int32_t>& numbers, PlanePolygon& polygon)
{
  for (PolygonEdge& edge : polygon.edges) {
    if (edge.neighbour < 0)
      continue;
    edge.neighbour = numbers[static_cast<std::size_t>(edge.neighbour)];
    if (edge.neighbour == removed)
      edge.kind = EdgeKind::Open;
  }
}

} // namespace

void
removeReplacedPlanes(MappedPlanes& mapped)
{
  const std::vector<std::int32_t> numbers =
      numbersWithout(mapped.cylinders, mapped.planes.size());
  std::vector<PlanePatch> kept;
  for (std::size_t p = 0; p < mapped.planes.size(); ++p) {
    if (numbers[p] == removed)
      continue;
    kept.push_back(std::move(mapped.planes[p]));
    for (PlanePolygon& polygon : kept.back().polygons)
      renumber(numbers, polygon);
  }
  mapped.planes = std::move(kept);
  renumberAll(numbers, mapped.labels);
  renumberAll(numbers, mapped.vertex_labels);
}

} // namespace pcl::acmap
