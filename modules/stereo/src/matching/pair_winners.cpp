#include "pair_winners.h"

#include "path_penalties.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr std::int16_t never = 30000;

/** Path costs of a row: one slot for each pixel and one on either side. */
class PathRow {
public:
  PathRow(int width, int stride)
  : slot_(stride + disparity_block)
  {
    for (std::size_t path = 0; path < 3; ++path) {
      // The padding before the first slot is the same as that behind each slot.
      costs_[path].assign(
          static_cast<std::size_t>(disparity_block + (width + 2) * slot_), never);
      minimum_[path].assign(static_cast<std::size_t>(width + 2), 0);
      for (int x = 0; x < width + 2; ++x)
        std::fill_n(costs_[path].begin() + disparity_block + x * slot_, stride, 0);
    }
  }

  PathRows
  rows()
  {
    PathRows rows{};
    for (std::size_t path = 0; path < 3; ++path) {
      rows.costs[path] = costs_[path].data() + disparity_block;
      rows.minimum[path] = minimum_[path].data();
    }
    return rows;
  }

private:
  std::int64_t slot_;
  std::vector<std::int16_t> costs_[3];
  std::vector<std::int16_t> minimum_[3];
};

/** Sums the costs of 3 x 3 pixels by disparity. Sums along paths are not suitable: in a
 * repetitive image they propagate the costs at the border over the whole image. */
void
sumCostsAround(const CostVolume& costs, int x, int y, std::vector<int>& sums)
{
  std::fill(sums.begin(), sums.end(), 0);
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, costs.height - 1); ++row)
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, costs.width - 1);
         ++column) {
      const std::int16_t* const from = costs.at(column, row);
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] += from[i];
    }
}

std::uint8_t
uniquenessOf(const std::vector<int>& sums, int best)
{
  // Lower bound of the costs: a perfect match alone is no evidence for uniqueness.
  constexpr int smallest = 100;
  int other = std::numeric_limits<int>::max() / 200;
  for (int i = 0; i < static_cast<int>(sums.size()); ++i)
    if (std::abs(i - best) > 1)
      other = std::min(other, sums[static_cast<std::size_t>(i)]);
  const int minimum = std::max(sums[static_cast<std::size_t>(best)], smallest);
  return static_cast<std::uint8_t>(
      std::clamp(100 * (other - minimum) / minimum, 0, 100));
}

void
findUniqueness(const CostVolume& costs,
               const DisparityRange& range,
               PairWinners& winners)
{
  oneapi::tbb::parallel_for(0, costs.height, [&](int y) {
    std::vector<int> sums(static_cast<std::size_t>(range.count));
    for (int x = 0; x < costs.width; ++x) {
      const auto at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(costs.width) +
          static_cast<std::size_t>(x);
      sumCostsAround(costs, x, y, sums);
      winners.uniqueness[at] = uniquenessOf(sums, winners.index[at]);
    }
  });
}

} // namespace

/** A pass over all rows in one direction: down from the first, or up from the last. */
class PathSums::Pass {
public:
  Pass(const ShotStack& image, const PathSettings& settings, CostVolume& costs, bool up)
  : penalties_(image, settings, up)
  , costs_(costs)
  , before_(costs.width, costs.stride)
  , after_(costs.width, costs.stride)
  , up_(up)
  {}

  void
  followRow(int y, std::int16_t* sums)
  {
    pairKernels().follow(
        costs_.row(y), penalties_.row(y), before_.rows(), after_.rows(), up_, sums);
    std::swap(before_, after_);
  }

private:
  PenaltyRows penalties_;
  CostVolume& costs_;
  PathRow before_, after_;
  bool up_;
};

void
PathSums::findWinners(const ShotStack& image,
                      const DisparityRange& range,
                      const PathSettings& settings,
                      CostVolume& costs,
                      PairWinners& winners)
{
  sums_.resize(costs.width, costs.height, costs.stride);
  const auto pixels =
      static_cast<std::size_t>(costs.width) * static_cast<std::size_t>(costs.height);
  winners.index.resize(pixels);
  winners.matched_by.resize(pixels);
  winners.uniqueness.resize(settings.uniqueness ? pixels : 0);
  {
    Pass down(image, settings, costs, false);
    for (int y = 0; y < costs.height; ++y)
      down.followRow(y, sums_.row(y).values);
  }
  Pass up(image, settings, costs, true);
  for (int y = costs.height - 1; y >= 0; --y) {
    up.followRow(y, sums_.row(y).values);
    findInRow(y, range, winners);
  }
  if (settings.uniqueness)
    findUniqueness(costs, range, winners);
}

void
PathSums::findInRow(int y, const DisparityRange& range, PairWinners& winners)
{
  const CostRow sums = sums_.row(y);
  const auto width = static_cast<std::size_t>(sums.width);
  const std::size_t begin = static_cast<std::size_t>(y) * width;
  target_minimum_.assign(width + static_cast<std::size_t>(sums.stride), 32767);
  target_pixel_.assign(target_minimum_.size(), -1);
  pairKernels().findWinners(
      sums,
      range.count,
      {&winners.index[begin], target_minimum_.data(), target_pixel_.data()});
  for (std::size_t x = 0; x < width; ++x) {
    const bool is_seen = x >= static_cast<std::size_t>(range.first);
    winners.matched_by[begin + x] =
        is_seen ? target_pixel_[x - static_cast<std::size_t>(range.first)]
                : std::int16_t{-1};
  }
}

} // namespace pcl::acmap
