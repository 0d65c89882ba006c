#include "labeling/junctions.h"

#include <cmath>
#include <unordered_map>

namespace pcl::acmap::labeling {
namespace {

/** Sums over the points of a plane near another plane: their distances from the latter
 * in metres, signed and absolute. */
struct Balance {
  double sum = 0;
  double total = 0;
};

constexpr int plane_bits = 32;

/** Balances by plane and neighbour, only of pairs that share a voxel: a map has
 * thousands of planes, but each has only a few neighbours. */
using Balances = std::unordered_map<std::uint64_t, Balance>;

Balances
balancesOf(const KnownPlanes& known, const CandidateGrid& grid)
{
  constexpr double parallel = 0.9;
  Balances balances;
  for (std::size_t i = 0; i < known.labels.size(); ++i) {
    VoxelHit hit;
    if (known.labels[i] < 0 || !grid.lattice().locate(known.points[i], hit))
      continue;
    const auto own = static_cast<std::size_t>(known.labels[i]);
    const Eigen::Vector4d& mine = known.planes[own].patch.coefficients;
    const Candidates& near = grid[grid.find(voxelKey(hit.place))];
    for (std::size_t k = 0; k < near.size; ++k) {
      const auto other = static_cast<std::size_t>(near.planes[k]);
      const Eigen::Vector4d& its = known.planes[other].patch.coefficients;
      if (other == own || std::abs(mine.head<3>().dot(its.head<3>())) > parallel)
        continue;
      const double off = its.head<3>().dot(known.points[i].cast<double>()) + its[3];
      Balance& balance = balances[std::uint64_t{own} << plane_bits | other];
      balance.sum += off;
      balance.total += std::abs(off);
    }
  }
  return balances;
}

} // namespace

Junctions::Junctions(const KnownPlanes& known, const CandidateGrid& grid)
: first_(known.planes.size() + 1, 0)
{
  constexpr double clear = 0.8;
  std::vector<std::pair<std::uint64_t, std::int8_t>> sides;
  for (const auto& [pair, balance] : balancesOf(known, grid))
    if (std::abs(balance.sum) > clear * balance.total)
      sides.emplace_back(pair, balance.sum > 0 ? std::int8_t{1} : std::int8_t{-1});
  std::sort(sides.begin(), sides.end());
  for (const auto& [pair, side] : sides) {
    ++first_[static_cast<std::size_t>(pair >> plane_bits) + 1];
    neighbours_.push_back({static_cast<std::uint32_t>(pair), side});
  }
  for (std::size_t p = 0; p < known.planes.size(); ++p)
    first_[p + 1] += first_[p];
}

} // namespace pcl::acmap::labeling
