#include "labeling/plane_sums.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace pcl::acmap::labeling {
namespace {

VoxelKey
clusterKey(VoxelKey key, int coarseness)
{
  VoxelPlace place = placeOf(key);
  for (std::int32_t& coordinate : place)
    coordinate /= coarseness;
  return voxelKey(place);
}

} // namespace

std::vector<PlaneSums>
sumPlanes(const Survey& survey,
          const std::vector<std::int32_t>& labels,
          const CandidateGrid& grid,
          const RangeNoise& noise,
          const std::vector<KnownPlane>& planes)
{
  std::vector<PlaneSums> all(planes.size());
  for (std::size_t i = 0; i < survey.size(); ++i) {
    const std::size_t count = survey.count(i);
    if (survey.entry(i) >= 0 && grid[survey.entry(i)].home >= 0)
      all[static_cast<std::size_t>(grid[survey.entry(i)].home)].points_at_home += count;
    if (labels[i] < 0 || survey.entry(i) < 0) // a member may be outside of the grid
      continue;
    const auto plane = static_cast<std::size_t>(labels[i]);
    const PlanePatch& patch = planes[plane].patch;
    const Crossing crossing(survey.sight(i), patch);
    const double weight = 1 / noise.variance(crossing, planes[plane]);
    const double times = static_cast<double>(count);
    const double squared = crossing.off * crossing.off;
    PlaneSums& sums = all[plane];
    sums.points += count;
    sums.squares += times * squared;
    sums.chi += times * weight * squared;
    if (weight * squared > squared_gate)
      continue;
    const bool is_clean = !grid.hasStrangersAt(crossing.foot, survey.entry(i));
    (is_clean ? sums.clean : sums.fit).add(crossing, patch, times * weight);
    sums.clean_points += is_clean ? count : 0;
  }
  for (PlaneSums& sums : all)
    sums.fit += sums.clean;
  return all;
}

std::vector<std::int32_t>
findShadows(const Survey& survey,
            const std::vector<std::int32_t>& labels,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes)
{
  constexpr double squared_reach = 20.25; // the same as for labelling
  constexpr double max_turn = -0.5;       // cosine; else it is the back of a thin wall
  std::vector<std::size_t> points(planes.size(), 0);
  std::vector<std::map<std::int32_t, std::size_t>> shared(planes.size());
  for (std::size_t i = 0; i < survey.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto own = static_cast<std::size_t>(labels[i]);
    points[own] += survey.count(i);
    const Candidates& candidates = grid[survey.entry(i)];
    for (std::size_t k = 0; k < candidates.size; ++k) {
      const std::int32_t other = candidates.planes[k];
      if (other >= labels[i])
        continue;
      const KnownPlane& caster = planes[static_cast<std::size_t>(other)];
      if (caster.patch.coefficients.head<3>().dot(
              planes[own].patch.coefficients.head<3>()) < max_turn)
        continue;
      const Crossing crossing(survey.sight(i), caster.patch);
      if (crossing.off * crossing.off <
              squared_reach * noise.variance(crossing, caster) &&
          grid.homeAt(crossing.foot) == other)
        shared[own][other] += survey.count(i);
    }
  }
  std::vector<std::int32_t> casters(planes.size(), -1);
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (const auto& [other, count] : shared[p])
      if (2 * count > points[p])
        casters[p] = other;
  return casters;
}

namespace {

/** Numbers of the clusters of each plane, assigned on first use. */
class ClusterNumbers {
public:
  ClusterNumbers(const CandidateGrid& grid, std::size_t planes, int coarseness)
  : grid_(grid)
  , coarseness_(coarseness)
  , numbers_(planes)
  , known_(grid.size() * Candidates::maximum, -1)
  {}

  std::size_t
  operator()(std::int32_t entry, std::int32_t plane)
  {
    const Candidates& candidates = grid_[entry];
    const auto begin = candidates.planes.begin();
    const auto place = std::find(begin, begin + candidates.size, plane) - begin;
    if (place == candidates.size) // the list of near planes is limited
      return lookUp(entry, plane);
    std::int32_t& known = known_[static_cast<std::size_t>(entry) * Candidates::maximum +
                                 static_cast<std::size_t>(place)];
    if (known < 0)
      known = static_cast<std::int32_t>(lookUp(entry, plane));
    return static_cast<std::size_t>(known);
  }

private:
  std::size_t
  lookUp(std::int32_t entry, std::int32_t plane)
  {
    auto& numbers = numbers_[static_cast<std::size_t>(plane)];
    return numbers
        .try_emplace(clusterKey(grid_.key(entry), coarseness_), numbers.size())
        .first->second;
  }

  const CandidateGrid& grid_;
  int coarseness_;
  std::vector<std::unordered_map<VoxelKey, std::size_t>> numbers_;
  std::vector<std::int32_t> known_;
};

} // namespace

void
sumClusters(const Survey& survey,
            const std::vector<std::int32_t>& labels,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes,
            int coarseness,
            std::vector<PlaneSums>& sums)
{
  ClusterNumbers numbers(grid, planes.size(), coarseness);
  for (std::size_t i = 0; i < survey.size(); ++i) {
    if (labels[i] < 0 || survey.entry(i) < 0)
      continue;
    const auto plane = static_cast<std::size_t>(labels[i]);
    PlaneSums& own = sums[plane];
    const PlanePatch& patch = planes[plane].patch;
    const Crossing crossing(survey.sight(i), patch);
    const double weight = 1 / noise.variance(crossing, planes[plane]);
    if (weight * crossing.off * crossing.off > squared_gate ||
        (own.isClean() && grid.hasStrangersAt(crossing.foot, survey.entry(i))))
      continue;
    const std::size_t cluster = numbers(survey.entry(i), labels[i]);
    if (cluster >= own.clusters.size())
      own.clusters.resize(cluster + 1);
    own.clusters[cluster].add(crossing, patch, weight);
  }
}

} // namespace pcl::acmap::labeling
