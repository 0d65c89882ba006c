#include "planes/noise_driven.h"

#include "planes/curved.h"
#include "planes/narrow_strips.h"
#include "planes/neighbourhoods.h"

namespace pcl::acmap::planes {
namespace {

using Members = std::vector<std::int32_t>;

double
areaOf(const CellGraph& graph, const Members& members)
{
  double area = 0;
  for (const std::int32_t member : members)
    area += graph.areas[static_cast<std::size_t>(member)];
  return area;
}

} // namespace

std::vector<GrownPlane>
growNoiseDriven(const CellGraph& graph,
                const std::vector<std::int32_t>& seeds,
                const PlaneLimits& limits,
                double least_area,
                PlaneClusteringReport& report)
{
  const GraphNeighbourhood neighbours(graph);
  std::vector<GrownPlane> grown;
  std::vector<std::int32_t> owner(graph.size(), no_region);
  const auto keep = [&](const Members& members,
                        const PlaneRegion& region,
                        double area,
                        PlaneTrust trust) {
    grown.push_back({members, region.moments(), region.plane(), area, trust});
    return true;
  };
  const auto isBent = [&](const Members& members, const PlaneRegion& region) {
    if (!isCurved(graph, members, owner, region, limits.cosine))
      return false;
    ++report.curved_regions;
    report.points_on_curved += members.size();
    for (const std::int32_t member : members)
      owner[static_cast<std::size_t>(member)] = curved_surface;
    return true;
  };
  const auto keepLarge = [&](const Members& members, const PlaneRegion& region) {
    const double area = areaOf(graph, members);
    if (area < least_area || isNarrow(region.moments(), graph.spacing))
      return false;
    return isBent(members, region) || keep(members, region, area, PlaneTrust::Sure);
  };
  const auto keepRest = [&](const Members& members, const PlaneRegion& region) {
    constexpr std::size_t least_members = 8;
    if (members.size() < least_members) {
      ++report.small_regions;
      return false;
    }
    const bool is_narrow = isNarrow(region.moments(), graph.spacing);
    return isBent(members, region) ||
           keep(members,
                region,
                areaOf(graph, members),
                is_narrow ? PlaneTrust::Strip : PlaneTrust::Small);
  };
  growPlanes(graph, neighbours, limits, seeds, owner, keepLarge);
  growPlanes(graph, neighbours, limits, seeds, owner, keepRest);
  return grown;
}

} // namespace pcl::acmap::planes
