#pragma once

#include "pair_costs.h"
#include "pair_winners.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Percent by which all sums more than one place away from the best are higher. */
std::uint8_t
uniquenessOf(const std::vector<int>& sums, int best);

/** \brief Sums the costs of 3 x 3 pixels by disparity. Sums along paths are not
 * suitable: in a repetitive image they propagate the costs at the border over the whole
 * image. */
template <typename Costs>
void
sumCostsAround(const Costs& costs, int x, int y, int unit, std::vector<int>& sums)
{
  std::fill(sums.begin(), sums.end(), 0);
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, costs.height - 1); ++row)
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, costs.width - 1);
         ++column) {
      const auto* const from = costs.at(column, row);
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] += unit * from[i];
    }
}

/** \brief Finds the uniqueness of all winners. Runs in all threads of the caller's arena.
 * \param[in] costs a volume of costs in multiples of \a unit */
template <typename Costs>
void
findUniqueness(const Costs& costs,
               int unit,
               const DisparityRange& range,
               PairWinners& winners)
{
  oneapi::tbb::parallel_for(0, costs.height, [&](int y) {
    std::vector<int> sums(static_cast<std::size_t>(range.count));
    for (int x = 0; x < costs.width; ++x) {
      const auto at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(costs.width) +
          static_cast<std::size_t>(x);
      sumCostsAround(costs, x, y, unit, sums);
      winners.uniqueness[at] = uniquenessOf(sums, winners.index[at]);
    }
  });
}

} // namespace pcl::acmap
