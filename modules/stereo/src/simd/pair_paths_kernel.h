// Sums of costs along paths, compiled once for each variant; included in the same way
// as lanes.h.
#pragma once

#include "lanes.h"
#include "pair_kernels.h"
#include "row_winners_kernel.h"

#include <cstring>

namespace {

using pcl::acmap::PathPenalties;
using pcl::acmap::PathRows;

/** State of a path: costs of its last pixel, and their minimum. */
struct PathStep {
  const std::int16_t* before;
  std::int16_t minimum;
  std::int16_t large; ///< P2
  std::int16_t* after;
};

/** Equation 13 of Hirschmueller (2008). */
ACMAP_INLINE Shorts
stepAt(const PathStep& step, const Shorts& cost, std::int16_t small, int i)
{
  const std::int16_t* const at = step.before + i;
  const Shorts beside = minimum(load<Shorts>(at - 1), load<Shorts>(at + 1)) + small;
  const Shorts jump = Shorts{} + static_cast<std::int16_t>(step.minimum + step.large);
  return cost + minimum(minimum(load<Shorts>(at), beside), jump) - step.minimum;
}

template <bool adds>
ACMAP_INLINE void
followPixel(const std::int16_t* costs,
            int stride,
            std::int16_t small,
            const PathStep (&steps)[4],
            std::int16_t (&found)[4],
            std::int16_t* sums)
{
  Shorts all[4];
  for (Shorts& one : all)
    one = Shorts{} + std::int16_t{32767};
  for (int i = 0; i < stride; i += pcl::acmap::disparity_block) {
    const Shorts cost = load<Shorts>(costs + i);
    UnsignedShorts sum = adds ? load<UnsignedShorts>(sums + i) : UnsignedShorts{};
    for (int path = 0; path < 4; ++path) {
      const Shorts value = stepAt(steps[path], cost, small, i);
      store(steps[path].after + i, value);
      all[path] = minimum(all[path], value);
      sum += (UnsignedShorts)value;
    }
    store(sums + i, sum);
  }
  for (int path = 0; path < 4; ++path)
    found[path] = leastOf(all[path]);
}

template <bool reversed>
void
followRow(const CostRow& costs,
          const PathPenalties& penalties,
          const PathRows& before,
          const PathRows& after,
          std::int16_t* sums)
{
  const std::int64_t slot = costs.stride + pcl::acmap::disparity_block;
  constexpr int ahead = reversed ? -1 : 1;
  // The path within the row alternates between the two slots beside the row, which are
  // never read by the path from straight above.
  std::int16_t* const row_ends[2] = {after.costs[1],
                                     after.costs[1] + (costs.width + 1) * slot};
  std::memset(row_ends[0], 0, static_cast<std::size_t>(costs.stride) * 2);
  std::int16_t min_of_row = 0;
  for (int n = 0; n < costs.width; ++n) {
    const int x = reversed ? costs.width - 1 - n : n;
    const std::int64_t at = x + 1;
    PathStep steps[4];
    steps[0] = {
        row_ends[n & 1], min_of_row, penalties.beside[x], row_ends[1 - (n & 1)]};
    for (int path = 0; path < 3; ++path) {
      const std::int64_t from = at + (path - 1) * ahead;
      steps[path + 1] = {before.costs[path] + from * slot,
                         before.minimum[path][from],
                         penalties.above[path][x],
                         after.costs[path] + at * slot};
    }
    std::int16_t found[4];
    followPixel<reversed>(costs.values + static_cast<std::int64_t>(x) * costs.stride,
                          costs.stride,
                          penalties.small,
                          steps,
                          found,
                          sums + static_cast<std::int64_t>(x) * costs.stride);
    min_of_row = found[0];
    for (int path = 0; path < 3; ++path)
      after.minimum[path][at] = found[path + 1];
  }
}

void
follow(const CostRow& costs,
       const PathPenalties& penalties,
       const PathRows& before,
       const PathRows& after,
       bool reversed,
       std::int16_t* sums)
{
  if (reversed)
    followRow<true>(costs, penalties, before, after, sums);
  else
    followRow<false>(costs, penalties, before, after, sums);
}

/** Sums are unsigned; after subtraction of 32768 they can be compared as signed. */
void
findWinners(const CostRow& sums, int disparities, const RowWinners& winners)
{
  findWinnersOf(
      sums.width,
      sums.stride,
      disparities,
      [&](std::int64_t at) {
        return load<Shorts>(sums.values + at) ^ static_cast<std::int16_t>(-32768);
      },
      winners);
}

} // namespace
