#include "pair_winners.h"

#include "path_penalties.h"
#include "uniqueness.h"
#include "winner_row.h"

#include <algorithm>
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

} // namespace

void
PairWinners::resize(std::size_t pixels, bool with_uniqueness)
{
  index.resize(pixels);
  matched_by.resize(pixels);
  uniqueness.resize(with_uniqueness ? pixels : 0);
}

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
  winners.resize(static_cast<std::size_t>(costs.width) *
                     static_cast<std::size_t>(costs.height),
                 settings.uniqueness);
  {
    Pass down(image, settings, costs, false);
    for (int y = 0; y < costs.height; ++y)
      down.followRow(y, sums_.row(y).values);
  }
  WinnerRow winner_row;
  Pass up(image, settings, costs, true);
  for (int y = costs.height - 1; y >= 0; --y) {
    up.followRow(y, sums_.row(y).values);
    pairKernels().findWinners(sums_.row(y),
                              range.count,
                              winner_row.begin(y, sums_.width, sums_.stride, winners));
    winner_row.finish(y, range, winners);
  }
  if (settings.uniqueness)
    findUniqueness(costs, 1, range, winners);
}

} // namespace pcl::acmap
