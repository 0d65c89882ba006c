#include "pair_costs.h"

#include "census.h"
#include "window_sums.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr float cost_of_no_correlation = 2000.0F;

/** Cost of a position outside the neighbour's image: not attractive, but better than a
 * bad match. */
constexpr std::int16_t outside_cost = 1500;

/** Replaces the costs of disparities that are outside the image, and of the padding. */
void
markOutside(const DisparityRange& range, const CostRow& row)
{
  for (int x = 0; x < row.width; ++x) {
    std::int16_t* const costs = row.values + static_cast<std::int64_t>(x) * row.stride;
    const int inside = std::clamp(row.width - x - range.first, 0, range.count);
    std::fill(costs + inside, costs + range.count, outside_cost);
    std::fill(costs + range.count, costs + row.stride, filled_cost);
  }
}

void
fillWindows(const ShotStack& reference,
            const ShotStack& target,
            const MatchingRecipe& recipe,
            const DisparityRange& range,
            CostVolume& costs)
{
  const WindowSums windows(reference, recipe, 0);
  const WindowSums target_windows(target, recipe, range.first + range.stride());
  const int radius = recipe.radius, width = costs.width + 2 * radius;
  const auto add = [&](int y, int sign, std::vector<std::int32_t>& sums) {
    pairKernels().addProducts(reference.rows(y, -radius),
                              target.rows(y, range.first - radius),
                              width,
                              costs.stride,
                              sign,
                              sums.data());
  };
  forRowBlocks(costs.height, [&](int begin, int end) {
    std::vector<std::int32_t> sums(static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(costs.stride));
    for (int y = begin - radius; y < begin + radius; ++y)
      add(y, 1, sums);
    for (int y = begin; y < end; ++y) {
      add(y + radius, 1, sums);
      pairKernels().correlateWindows(sums.data(),
                                     radius,
                                     windows.row(y, 0),
                                     target_windows.row(y, range.first),
                                     cost_of_no_correlation,
                                     costs.row(y));
      add(y - radius, -1, sums);
    }
  });
}

void
fillCensus(const ShotStack& reference,
           const ShotStack& target,
           const MatchingRecipe& recipe,
           const DisparityRange& range,
           CostVolume& costs)
{
  const Census census(reference, 0);
  const Census target_census(target, range.first + range.stride());
  oneapi::tbb::parallel_for(0, costs.height, [&](int y) {
    pairKernels().countBits(census.row(y),
                            target_census.row(y, range.first),
                            recipe.cost_of_bit,
                            costs.row(y));
  });
}

} // namespace

void
fillCosts(const ShotStack& reference,
          const ShotStack& target,
          const MatchingRecipe& recipe,
          const DisparityRange& range,
          CostVolume& costs)
{
  costs.resize(reference.width(), reference.height(), range.stride());
  if (recipe.cost == PairCost::Census)
    fillCensus(reference, target, recipe, range, costs);
  else
    fillWindows(reference, target, recipe, range, costs);
  oneapi::tbb::parallel_for(
      0, costs.height, [&](int y) { markOutside(range, costs.row(y)); });
}

} // namespace pcl::acmap
