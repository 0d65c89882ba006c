#include "byte_paths.h"

#include "uniqueness.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace pcl::acmap {

namespace {

/** Path costs of a row: one slot for each pixel and one on either side. */
class BytePathRow {
public:
  BytePathRow(int width, int stride)
  {
    const std::ptrdiff_t slot = stride + byte_block;
    for (std::size_t path = 0; path < 3; ++path) {
      // The padding before the first slot is the same as that behind each slot.
      costs_[path].assign(static_cast<std::size_t>(byte_block + (width + 2) * slot),
                          never_byte_cost);
      minimum_[path].assign(static_cast<std::size_t>(width + 2), 0);
      for (std::ptrdiff_t x = 0; x < width + 2; ++x)
        std::fill_n(costs_[path].begin() + byte_block + x * slot, stride, 0);
    }
  }

  BytePathRows
  rows()
  {
    BytePathRows rows{};
    for (std::size_t path = 0; path < 3; ++path) {
      rows.costs[path] = costs_[path].data() + byte_block;
      rows.minimum[path] = minimum_[path].data();
    }
    return rows;
  }

private:
  std::vector<std::uint8_t> costs_[3];
  std::vector<std::uint8_t> minimum_[3];
};

} // namespace

/** A pass over all rows in one direction: down from the first, or up from the last. */
class BytePaths::Pass {
public:
  Pass(const BytePenalties& penalties,
       ByteVolume& costs,
       std::vector<std::uint8_t>& excess,
       bool up)
  : penalties_(penalties)
  , costs_(costs)
  , excess_(excess)
  , before_(costs.width, costs.stride)
  , after_(costs.width, costs.stride)
  , up_(up)
  {}

  const std::uint8_t*
  followRow(int y)
  {
    std::uint8_t* const excess =
        excess_.data() + static_cast<std::int64_t>(y) * costs_.width * costs_.stride;
    byteKernels().follow(
        costs_.row(y), penalties_, before_.rows(), after_.rows(), up_, excess);
    std::swap(before_, after_);
    return excess;
  }

private:
  BytePenalties penalties_;
  ByteVolume& costs_;
  std::vector<std::uint8_t>& excess_;
  BytePathRow before_, after_;
  bool up_;
};

void
BytePaths::findWinners(const DisparityRange& range,
                       const BytePenalties& penalties,
                       bool uniqueness,
                       ByteVolume& costs,
                       PairWinners& winners)
{
  excess_.resize(costs.values.size());
  winners.resize(static_cast<std::size_t>(costs.width) *
                     static_cast<std::size_t>(costs.height),
                 uniqueness);
  {
    Pass down(penalties, costs, excess_, false);
    for (int y = 0; y < costs.height; ++y)
      down.followRow(y);
  }
  Pass up(penalties, costs, excess_, true);
  for (int y = costs.height - 1; y >= 0; --y) {
    const std::uint8_t* const excess = up.followRow(y);
    byteKernels().findWinners(costs.row(y),
                              excess,
                              range.count,
                              winner_row_.begin(y, costs.width, costs.stride, winners));
    winner_row_.finish(y, range, winners);
  }
  if (uniqueness)
    findUniqueness(costs, byte_cost_unit, range, winners);
}

} // namespace pcl::acmap
