// The minima of sums, compiled once for each variant; included in the same way as
// lanes.h.
#pragma once

#include "lanes.h"
#include "pair_kernels.h"

namespace {

using pcl::acmap::RowWinners;

constexpr Shorts first_indices{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

ACMAP_INLINE void
offerToTarget(const Shorts& value, int x, int at, const RowWinners& winners)
{
  const Shorts held = load<Shorts>(winners.target_minimum + at);
  const Shorts pixel = load<Shorts>(winners.target_pixel + at);
  const auto better = value < held;
  store(winners.target_minimum + at, better ? value : held);
  store(winners.target_pixel + at,
        better ? Shorts{} + static_cast<std::int16_t>(x) : pixel);
}

/** \param[in] sums function of the place of sixteen sums; they are compared as signed */
template <typename Sums>
ACMAP_INLINE void
findWinnersOf(
    int width, int stride, int disparities, const Sums& sums, const RowWinners& winners)
{
  for (int x = 0; x < width; ++x) {
    const std::int64_t row = static_cast<std::int64_t>(x) * stride;
    Shorts best = Shorts{} + std::int16_t{32767}, block = Shorts{};
    for (int i = 0; i < stride; i += pcl::acmap::disparity_block) {
      const Shorts index = first_indices + static_cast<std::int16_t>(i);
      const Shorts value = index < static_cast<std::int16_t>(disparities)
                               ? sums(row + i)
                               : Shorts{} + std::int16_t{32767};
      const auto better = value < best;
      best = better ? value : best;
      block = better ? Shorts{} + static_cast<std::int16_t>(i) : block;
      offerToTarget(value, x, x + i, winners);
    }
    const std::int16_t found = leastOf(best);
    const Shorts index =
        best == found ? block + first_indices : Shorts{} + std::int16_t{32767};
    winners.index[x] = leastOf(index);
  }
}

} // namespace
