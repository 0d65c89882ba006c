#include "labeling/junctions.h"

#include <cmath>

namespace pcl::acmap::labeling {

Junctions::Junctions(const KnownPlanes& known, const CandidateGrid& grid)
: planes_(known.planes.size())
, sides_(planes_ * planes_, 0)
{
  constexpr double parallel = 0.9;
  std::vector<double> balance(planes_ * planes_, 0), total(planes_ * planes_, 0);
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
      balance[own * planes_ + other] += off;
      total[own * planes_ + other] += std::abs(off);
    }
  }
  constexpr double clear = 0.8;
  for (std::size_t pair = 0; pair < sides_.size(); ++pair)
    if (std::abs(balance[pair]) > clear * total[pair])
      sides_[pair] = balance[pair] > 0 ? 1 : balance[pair] < 0 ? -1 : 0;
}

} // namespace pcl::acmap::labeling
