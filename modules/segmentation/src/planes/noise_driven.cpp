#include "planes/noise_driven.h"

#include "planes/curved.h"
#include "planes/narrow_strips.h"
#include "planes/neighbourhoods.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::planes {
namespace {

using Members = std::vector<std::int32_t>;

/** State of one run: the owner of each hypothesis, and the planes so far. */
class NoiseDrivenGrowth {
public:
  NoiseDrivenGrowth(const CellGraph& graph,
                    double min_area,
                    PlaneClusteringReport& report)
  : graph_(graph)
  , neighbours_(graph)
  , min_area_(min_area)
  , report_(report)
  , owner_(graph.size(), no_region)
  {}

  void
  growLarge(const std::vector<std::int32_t>& seeds, const PlaneLimits& limits)
  {
    grow(seeds, limits, [&](const Members& members, const PlaneRegion& region) {
      const double area = graph_.areaOf(members);
      if (area < min_area_ || isNarrow(region.moments(), graph_.spacing))
        return false;
      return isBent(members, region, limits) ||
             keep(members, region, area, PlaneTrust::Sure);
    });
  }

  void
  growRest(const std::vector<std::int32_t>& seeds, const PlaneLimits& limits)
  {
    grow(seeds, limits, [&](const Members& members, const PlaneRegion& region) {
      constexpr std::size_t min_members = 8;
      if (members.size() < min_members) {
        ++report_.small_regions;
        return false;
      }
      const bool is_narrow = isNarrow(region.moments(), graph_.spacing);
      return isBent(members, region, limits) ||
             keep(members,
                  region,
                  graph_.areaOf(members),
                  is_narrow ? PlaneTrust::Strip : PlaneTrust::Small);
    });
  }

  /** Warped walls and misregistered clouds deviate by more than noise. Such a wall ends
   * at its own edges if the band is wide enough, unlike a curved surface, which
   * continues smoothly beyond any band. */
  void
  growWarped(const std::vector<std::int32_t>& seeds, PlaneLimits limits)
  {
    constexpr double widening = 1.4142;
    is_wide_ = true;
    while (report_.curved_regions > 0 && limits.distance * widening < limits.max_warp) {
      limits.distance *= widening;
      freeCurved();
      growLarge(seeds, limits);
    }
    is_wide_ = false;
  }

  std::vector<GrownPlane>
  take()
  {
    return std::move(grown_);
  }

private:
  template <typename Accept>
  void
  grow(const std::vector<std::int32_t>& seeds,
       const PlaneLimits& limits,
       const Accept& accept)
  {
    growPlanes(graph_, neighbours_, limits, seeds, next_, owner_, accept);
  }

  bool
  keep(const Members& members, const PlaneRegion& region, double area, PlaneTrust trust)
  {
    const double warp =
        is_wide_ ? std::sqrt(fitPlane(region.moments()).variances[0]) : 0;
    grown_.push_back({members, region.moments(), region.plane(), area, trust, warp});
    return true;
  }

  bool
  isBent(const Members& members, const PlaneRegion& region, const PlaneLimits& limits)
  {
    if (!isCurved(graph_, members, owner_, region, limits.cosine))
      return false;
    ++report_.curved_regions;
    report_.points_on_curved += members.size();
    for (const std::int32_t member : members)
      owner_[static_cast<std::size_t>(member)] = curved_surface;
    return true;
  }

  void
  freeCurved()
  {
    std::replace(owner_.begin(), owner_.end(), curved_surface, no_region);
    report_.curved_regions = report_.points_on_curved = 0;
  }

  const CellGraph& graph_;
  GraphNeighbourhood neighbours_;
  double min_area_;
  PlaneClusteringReport& report_;
  std::vector<std::int32_t> owner_;
  std::vector<GrownPlane> grown_;
  std::int32_t next_ = 0; ///< number of the next region
  bool is_wide_ = false;  ///< is the band wider than for noise alone?
};

} // namespace

std::vector<GrownPlane>
growNoiseDriven(const CellGraph& graph,
                const std::vector<std::int32_t>& seeds,
                const PlaneLimits& limits,
                double min_area,
                PlaneClusteringReport& report)
{
  NoiseDrivenGrowth growth(graph, min_area, report);
  growth.growLarge(seeds, limits);
  if (limits.bow > 0)
    growth.growWarped(seeds, limits);
  growth.growRest(seeds, limits);
  return growth.take();
}

} // namespace pcl::acmap::planes
