#include "planes/plane_growth.h"

#include "planes/neighbourhoods.h"

#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <algorithm>

namespace pcl::acmap::planes {

namespace {

/** \brief Reports the progress of growing by the number of point pairs that were
 * visited: this number, and so the time, grows with the square of the number of points
 * within W_d. */
class PairProgress {
public:
  PairProgress(const CellGraph& graph,
               const RadiusNeighbourhood& near,
               const Progress& progress)
  : progress_(progress)
  , is_closed_(graph.size(), false)
  {
    constexpr std::size_t samples = 100;
    constexpr double visits = 2; // per point: when it joins, and in the final check
    const std::size_t step = 1 + graph.size() / samples;
    std::size_t pairs = 0, points = 0;
    for (std::size_t i = 0; i < graph.size(); i += step, ++points)
      near.visit(static_cast<std::int32_t>(i), [&](std::int32_t) { ++pairs; });
    pairs_each_ = visits * static_cast<double>(pairs) /
                  std::max(1.0, static_cast<double>(points));
  }

  void
  addPairs(std::size_t pairs)
  {
    pairs_ += static_cast<double>(pairs);
    constexpr double pairs_between = 1 << 22; // a few hundredths of a second
    if (pairs_ - told_ < pairs_between)
      return;
    told_ = pairs_;
    const auto open = static_cast<double>(is_closed_.size() - closed_);
    share_ = std::max(share_, pairs_ / (pairs_ + pairs_each_ * open));
    progress_.tell(share_of_growth * share_, "growing");
  }

  /** \brief Marks the members of a region, which are no longer seeds. If regions are
   * rejected and their members are visited again, the estimate for the remaining points
   * is increased. */
  void
  close(const std::vector<std::int32_t>& members)
  {
    for (const std::int32_t member : members) {
      closed_ += is_closed_[static_cast<std::size_t>(member)] ? 0 : 1;
      is_closed_[static_cast<std::size_t>(member)] = true;
    }
    if (closed_ > 0)
      pairs_each_ = std::max(pairs_each_, pairs_ / static_cast<double>(closed_));
  }

private:
  static constexpr double share_of_growth = 0.85; ///< of all steps of the clustering

  const Progress& progress_;
  std::vector<bool> is_closed_;
  std::size_t closed_ = 0;
  double pairs_each_ = 0;       ///< expected per open point
  double pairs_ = 0, told_ = 0; ///< visited so far, and at the last report
  double share_ = 0;            ///< last reported; it never decreases
};

/** \brief Points within W_d; the visited pairs are counted. */
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
            std::size_t min_support,
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
               pairs.close(members);
               if (members.size() <= min_support) {
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

double
pcl::acmap::secondsOfPaperGrowth(const PointView& points, double member_distance)
{
  constexpr std::size_t samples = 200;
  constexpr double seconds_per_pair = 120e-9;
  const std::size_t step = 1 + points.size() / samples;
  double pairs = 0, sampled = 0;
  for (std::size_t i = 0; i < points.size(); i += step, ++sampled)
    for (std::size_t k = 0; k < points.size(); ++k)
      pairs += (points[i] - points[k]).squaredNorm() <
               static_cast<float>(member_distance * member_distance);
  return seconds_per_pair * pairs * static_cast<double>(points.size()) /
         std::max(1.0, sampled);
}
