#include "consolidation/thinning.h"

#include "consolidation/point_hash.h"

#include <algorithm>
#include <numeric>

namespace pcl::acmap {

namespace {

constexpr double min_distance = 0.7; // edges
constexpr double min_distance_of_strays = 0.85;

/** Were they seen from opposite sides of a thin wall? */
bool
areOpposite(const Candidate& a, const Candidate& b)
{
  return (a.octants & b.octants) == 0;
}

/** \return the closest kept candidate that displaces this one, -1 if there is none */
std::int32_t
displacing(const std::vector<Candidate>& candidates,
           const PointHash& kept,
           const Candidate& candidate,
           double edge)
{
  // a point that left its voxel is only needed if there would be a hole without it
  const double radius =
      edge * (candidate.strayed > 0 ? min_distance_of_strays : min_distance);
  double minimum = radius * radius;
  std::int32_t found = -1;
  const Eigen::Vector3f& point = candidate.representative.point;
  kept.visitNear(point, [&](std::uint32_t other) {
    const Candidate& earlier = candidates[other];
    const double distance = (earlier.representative.point - point).squaredNorm();
    const auto name = static_cast<std::int32_t>(other);
    if ((distance < minimum || (distance == minimum && name < found)) &&
        !areOpposite(earlier, candidate)) {
      minimum = distance;
      found = name;
    }
    return false;
  });
  return found;
}

std::vector<std::uint32_t>
orderOf(const std::vector<Candidate>& candidates)
{
  std::vector<std::uint32_t> order(candidates.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto strays =
      std::stable_partition(order.begin(), order.end(), [&](std::uint32_t c) {
        return candidates[c].strayed == 0;
      });
  std::stable_sort(strays, order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return candidates[a].strayed < candidates[b].strayed;
  });
  return order;
}

} // namespace

Thinning
thinOut(const std::vector<Candidate>& candidates, double edge)
{
  PointHash kept(candidates.size(), static_cast<float>(min_distance_of_strays * edge));
  Thinning thinning;
  std::vector<std::int32_t> displaced_by(candidates.size(), -1);
  for (const std::uint32_t candidate : orderOf(candidates)) {
    displaced_by[candidate] = displacing(candidates, kept, candidates[candidate], edge);
    if (displaced_by[candidate] < 0) {
      kept.add(candidate, candidates[candidate].representative.point);
      thinning.kept.push_back(candidate);
    }
  }
  std::sort(thinning.kept.begin(), thinning.kept.end());
  thinning.stand_in.assign(candidates.size(), -1);
  for (std::size_t k = 0; k < thinning.kept.size(); ++k)
    thinning.stand_in[thinning.kept[k]] = static_cast<std::int32_t>(k);
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (displaced_by[c] >= 0)
      thinning.stand_in[c] =
          thinning.stand_in[static_cast<std::size_t>(displaced_by[c])];
  return thinning;
}

} // namespace pcl::acmap
