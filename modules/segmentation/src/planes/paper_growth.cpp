#include "planes/paper_growth.h"

#include "planes/neighbourhoods.h"

namespace pcl::acmap::planes {

std::vector<GrownPlane>
growAsPaper(const CellGraph& graph,
            const std::vector<std::int32_t>& seeds,
            const PlaneLimits& limits,
            double member_distance,
            std::size_t least_support,
            PlaneClusteringReport& report)
{
  const RadiusNeighbourhood neighbours(graph, member_distance);
  std::vector<GrownPlane> grown;
  std::vector<std::int32_t> owner(graph.size(), no_region);
  std::int32_t next = 0;
  growPlanes(graph,
             neighbours,
             limits,
             seeds,
             next,
             owner,
             [&](const std::vector<std::int32_t>& members, const PlaneRegion& region) {
               if (members.size() <= least_support) {
                 ++report.small_regions;
                 return false;
               }
               grown.push_back({members,
                                region.moments(),
                                region.plane(),
                                graph.areaOf(members),
                                PlaneTrust::Sure});
               return true;
             });
  return grown;
}

} // namespace pcl::acmap::planes
