// Sums of costs in bytes along paths, compiled once for each variant; included in the
// same way as lanes.h.
#pragma once

#include "byte_kernels.h"
#include "lanes.h"
#include "row_winners_kernel.h"

#include <cstring>

namespace {

using pcl::acmap::byte_block;
using pcl::acmap::BytePathRows;
using pcl::acmap::BytePenalties;
using pcl::acmap::ByteRow;

/** State of a path from the previous row, and P1 and P2 that begin at its minimum. */
struct BytePath {
  const std::uint8_t* before;
  std::uint8_t* after;
  Bytes minimum;
  Bytes jump;
};

ACMAP_INLINE Bytes
excessOf(const BytePath& path, const Bytes& at, const Bytes& beside, std::uint8_t small)
{
  return minimum(minimum(at, beside + small), path.jump) - path.minimum;
}

/** The path within the row reads what it has just written: shifting blocks in registers
 * is faster than loading across two stores. */
struct RowPath {
  std::uint8_t* costs;
  Bytes before; ///< the block before the current one, as it was
  Bytes here;   ///< the current one

  ACMAP_INLINE Bytes
  beside(int i, int stride)
  {
    const Bytes behind = i + byte_block < stride
                             ? load<Bytes>(costs + i + byte_block)
                             : Bytes{} + pcl::acmap::never_byte_cost;
    const Bytes least = minimum(lastAnd(before, here), firstBehind(here, behind));
    before = here;
    here = behind;
    return least;
  }
};

template <bool adds>
ACMAP_INLINE Bytes
followPixel(const std::uint8_t* costs,
            int stride,
            std::uint8_t small,
            const BytePath (&paths)[4],
            std::uint8_t* excess)
{
  Bytes all[4];
  for (Bytes& one : all)
    one = Bytes{} + std::uint8_t{255};
  RowPath row{paths[0].after,
              Bytes{} + pcl::acmap::never_byte_cost,
              load<Bytes>(paths[0].after)};
  for (int i = 0; i < stride; i += byte_block) {
    const Bytes cost = load<Bytes>(costs + i);
    Bytes sum = adds ? load<Bytes>(excess + i) : Bytes{};
    const auto advance = [&](int path, const Bytes& at, const Bytes& beside) {
      const Bytes more = excessOf(paths[path], at, beside, small);
      const Bytes value = cost + more;
      store(paths[path].after + i, value);
      all[path] = minimum(all[path], value);
      sum += more;
    };
    const Bytes here = row.here;
    advance(0, here, row.beside(i, stride));
    for (int path = 1; path < 4; ++path) {
      const std::uint8_t* const at = paths[path].before + i;
      advance(path, load<Bytes>(at), minimum(load<Bytes>(at - 1), load<Bytes>(at + 1)));
    }
    store(excess + i, sum);
  }
  return leastOfFour(all);
}

/** \tparam fixed stride that is known at compile time, or 0 */
template <bool reversed, int fixed>
void
followByteRow(const ByteRow& costs,
              const BytePenalties& penalties,
              const BytePathRows& before,
              const BytePathRows& after,
              std::uint8_t* excess)
{
  const int stride = fixed > 0 ? fixed : costs.stride;
  const std::int64_t slot = stride + byte_block;
  constexpr int ahead = reversed ? -1 : 1;
  // The slot before the row is never read by the path from straight above.
  BytePath paths[4];
  paths[0].before = paths[0].after = after.costs[1];
  paths[0].minimum = Bytes{};
  std::memset(after.costs[1], 0, static_cast<std::size_t>(stride));
  for (int n = 0; n < costs.width; ++n) {
    const int x = reversed ? costs.width - 1 - n : n;
    const std::int64_t at = x + 1;
    paths[0].jump = paths[0].minimum + penalties.large;
    for (int path = 0; path < 3; ++path) {
      const std::int64_t from = at + (path - 1) * ahead;
      BytePath& one = paths[path + 1];
      one.before = before.costs[path] + from * slot;
      one.after = after.costs[path] + at * slot;
      one.minimum = Bytes{} + before.minimum[path][from];
      one.jump = one.minimum + penalties.large;
    }
    const std::int64_t first = static_cast<std::int64_t>(x) * stride;
    const Bytes found = followPixel<reversed>(
        costs.values + first, stride, penalties.small, paths, excess + first);
    paths[0].minimum = spreadFirst(found);
    for (int path = 0; path < 3; ++path)
      after.minimum[path][at] = found[8 * (path + 1)];
  }
}

void
followBytes(const ByteRow& costs,
            const BytePenalties& penalties,
            const BytePathRows& before,
            const BytePathRows& after,
            bool reversed,
            std::uint8_t* excess)
{
  constexpr int usual = 64; // disparities
  const auto follow =
      costs.stride == usual
          ? (reversed ? followByteRow<true, usual> : followByteRow<false, usual>)
          : (reversed ? followByteRow<true, 0> : followByteRow<false, 0>);
  follow(costs, penalties, before, after, excess);
}

void
findByteWinners(const ByteRow& costs,
                const std::uint8_t* excess,
                int disparities,
                const RowWinners& winners)
{
  constexpr int paths = 8;
  findWinnersOf(
      costs.width,
      costs.stride,
      disparities,
      [&](std::int64_t at) {
        const Shorts cost =
            __builtin_convertvector(load<SixteenBytes>(costs.values + at), Shorts);
        const Shorts more =
            __builtin_convertvector(load<SixteenBytes>(excess + at), Shorts);
        return paths * cost + more;
      },
      winners);
}

} // namespace
