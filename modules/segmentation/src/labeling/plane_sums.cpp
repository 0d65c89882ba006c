#include "labeling/plane_sums.h"

#include <pcl/core/impl/parallel.h>

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

/** \param[in] members of the plane */
PlaneSums
sumPlane(const Survey& survey,
         PlaneMembers::Range members,
         const CandidateGrid& grid,
         const RangeNoise& noise,
         const KnownPlane& plane)
{
  PlaneSums sums;
  for (const std::size_t i : members) {
    if (survey.entry(i) < 0) // a member may be outside of the grid
      continue;
    const std::size_t count = survey.count(i);
    const Crossing crossing(survey.sight(i), plane.patch);
    const double weight = 1 / noise.variance(crossing, plane);
    const double times = static_cast<double>(count);
    const double squared = crossing.off * crossing.off;
    sums.points += count;
    sums.squares += times * squared;
    sums.chi += times * weight * squared;
    if (weight * squared > squared_gate)
      continue;
    const bool is_clean = !grid.hasStrangersAt(crossing.foot, survey.entry(i));
    (is_clean ? sums.clean : sums.fit).add(crossing, plane.patch, times * weight);
    sums.clean_points += is_clean ? count : 0;
  }
  sums.fit += sums.clean;
  return sums;
}

} // namespace

std::vector<PlaneSums>
sumPlanes(const Survey& survey,
          const PlaneMembers& members,
          const CandidateGrid& grid,
          const RangeNoise& noise,
          const std::vector<KnownPlane>& planes)
{
  std::vector<PlaneSums> all(planes.size());
  members.forEachPlane([&](std::size_t plane, PlaneMembers::Range own) {
    all[plane] = sumPlane(survey, own, grid, noise, planes[plane]);
  });
  return all;
}

void
countAtHome(const Survey& survey,
            const CandidateGrid& grid,
            std::vector<PlaneSums>& sums)
{
  for (std::size_t i = 0; i < survey.size(); ++i)
    if (survey.entry(i) >= 0 && grid[survey.entry(i)].home >= 0)
      sums[static_cast<std::size_t>(grid[survey.entry(i)].home)].points_at_home +=
          survey.count(i);
}

std::vector<std::int32_t>
findShadows(const Survey& survey,
            const PlaneMembers& members,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes)
{
  constexpr double squared_reach = 20.25; // the same as for labelling
  constexpr double max_turn = -0.5;       // cosine; else it is the back of a thin wall
  std::vector<std::int32_t> casters(planes.size(), -1);
  members.forEachPlane([&](std::size_t own, PlaneMembers::Range range) {
    std::size_t points = 0;
    std::map<std::int32_t, std::size_t> shared;
    for (const std::size_t i : range) {
      points += survey.count(i);
      const Candidates& candidates = grid[survey.entry(i)];
      for (std::size_t k = 0; k < candidates.size; ++k) {
        const std::int32_t other = candidates.planes[k];
        if (other >= static_cast<std::int32_t>(own))
          continue;
        const KnownPlane& caster = planes[static_cast<std::size_t>(other)];
        if (caster.patch.coefficients.head<3>().dot(
                planes[own].patch.coefficients.head<3>()) < max_turn)
          continue;
        const Crossing crossing(survey.sight(i), caster.patch);
        if (crossing.off * crossing.off <
                squared_reach * noise.variance(crossing, caster) &&
            grid.homeAt(crossing.foot) == other)
          shared[other] += survey.count(i);
      }
    }
    for (const auto& [other, count] : shared)
      if (2 * count > points)
        casters[own] = other;
  });
  return casters;
}

namespace {

/** Numbers of the clusters of each plane, assigned on first use. Different planes may be
 * asked for at the same time. */
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
  LargeVector<std::int32_t> known_;
};

} // namespace

void
sumClusters(const Survey& survey,
            const PlaneMembers& members,
            const CandidateGrid& grid,
            const RangeNoise& noise,
            const std::vector<KnownPlane>& planes,
            int coarseness,
            std::vector<PlaneSums>& sums)
{
  ClusterNumbers numbers(grid, planes.size(), coarseness);
  members.forEachPlane([&](std::size_t plane, PlaneMembers::Range range) {
    const PlanePatch& patch = planes[plane].patch;
    const bool is_clean = sums[plane].isClean();
    LargeVector<FitSums>& clusters = sums[plane].clusters;
    for (const std::size_t i : range) {
      const std::int32_t entry = survey.entry(i);
      if (entry < 0)
        continue;
      const Crossing crossing(survey.sight(i), patch);
      const double weight = 1 / noise.variance(crossing, planes[plane]);
      if (weight * crossing.off * crossing.off > squared_gate ||
          (is_clean && grid.hasStrangersAt(crossing.foot, entry)))
        continue;
      const std::size_t cluster = numbers(entry, static_cast<std::int32_t>(plane));
      if (cluster >= clusters.size())
        clusters.resize(cluster + 1);
      clusters[cluster].add(crossing, patch, weight);
    }
  });
}

} // namespace pcl::acmap::labeling
