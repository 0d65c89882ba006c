#include "planes/paper_growth.h"

#include "planes/neighbourhoods.h"

#include <algorithm>

namespace pcl::acmap::planes {

namespace {

/** \brief Tells how far growing is, by the pairs of points that it has looked at: their
 * number, and so the time, grows with the square of the points within W_d. */
class PairProgress {
public:
  PairProgress(const CellGraph& graph,
               const RadiusNeighbourhood& near,
               const Progress& progress)
  : progress_(progress)
  , open_points_(static_cast<double>(graph.size()))
  {
    constexpr std::size_t samples = 100;
    const std::size_t step = 1 + graph.size() / samples;
    std::size_t pairs = 0, points = 0;
    for (std::size_t i = 0; i < graph.size(); i += step, ++points)
      near.visit(static_cast<std::int32_t>(i), [&](std::int32_t) { ++pairs; });
    pairs_each_ = static_cast<double>(pairs) / std::max(1.0, double(points));
  }

  void
  addPairs(std::size_t pairs)
  {
    pairs_ += static_cast<double>(pairs);
    constexpr double pairs_between = 1 << 22; // some hundredths of a second
    if (pairs_ - told_ < pairs_between)
      return;
    told_ = pairs_;
    constexpr double visits =
        2; // of a point: when it joins, and when all are looked at
    progress_.tell(share_of_growth * pairs_ /
                       (pairs_ + visits * pairs_each_ * open_points_),
                   "growing");
  }

  /** \brief Points that no pairs will be looked for any more. */
  void
  close(std::size_t points)
  {
    open_points_ = std::max(0.0, open_points_ - static_cast<double>(points));
  }

private:
  static constexpr double share_of_growth = 0.85; ///< of all steps of the clustering

  const Progress& progress_;
  double open_points_;
  double pairs_each_ = 0;       ///< mean number within W_d of a point
  double pairs_ = 0, told_ = 0; ///< looked at so far, and when it was last told
};

/** \brief Who is nearer than W_d, counted. */
class CountedNeighbourhood {
public:
  CountedNeighbourhood(const RadiusNeighbourhood& near, PairProgress& progress)
  : near_(near)
  , progress_(progress)
  {}

  template <typename Visit>
  void
  visit(std::int32_t element, const Visit& visit) const
  {
    std::size_t pairs = 0;
    near_.visit(element, [&](std::int32_t other) {
      ++pairs;
      visit(other);
    });
    progress_.addPairs(pairs);
  }

private:
  const RadiusNeighbourhood& near_;
  PairProgress& progress_;
};

} // namespace

std::vector<GrownPlane>
growAsPaper(const CellGraph& graph,
            const std::vector<std::int32_t>& seeds,
            const PlaneLimits& limits,
            double member_distance,
            std::size_t least_support,
            const Progress& progress,
            PlaneClusteringReport& report)
{
  const RadiusNeighbourhood near(graph, member_distance);
  PairProgress pairs(graph, near, progress);
  std::vector<GrownPlane> grown;
  std::vector<std::int32_t> owner(graph.size(), no_region);
  std::int32_t next = 0;
  growPlanes(graph,
             CountedNeighbourhood(near, pairs),
             limits,
             seeds,
             next,
             owner,
             [&](const std::vector<std::int32_t>& members, const PlaneRegion& region) {
               pairs.close(members.size());
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
