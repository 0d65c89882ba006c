// Costs over time in bytes, compiled once for each variant; included in the same way as
// lanes.h.
#pragma once

#include "byte_kernels.h"
#include "lanes.h"

#include <algorithm>

namespace {

using pcl::acmap::ByteRow;
using pcl::acmap::ShotRows;

// The product of two equal codes is 2000 in units of a byte cost, times 2^21, so that a
// cost needs neither a multiplication nor a division.
constexpr int code_shift = 21;
constexpr auto full_code = static_cast<std::int32_t>(
    (std::int64_t{2000} << code_shift) / pcl::acmap::byte_cost_unit);
constexpr float code_norm = 17962.14F; // the root of full_code

/** Rounds to the nearest integer; |value| < 2^15. */
ACMAP_INLINE Ints
roundedOf(const Floats& value)
{
  constexpr float above = 32768.5F; // positive numbers are rounded down
  return __builtin_convertvector(value + above, Ints) - 32768;
}

ACMAP_INLINE Floats
levelsOf(const ShotRows<std::int16_t>& rows, int shot, int x)
{
  return __builtin_convertvector(
      widened(load<EightShorts>(rows.values + shot * rows.plane + x)), Floats);
}

void
encode(const ShotRows<std::int16_t>& levels,
       int width,
       float floor,
       std::int64_t plane,
       std::int32_t* codes)
{
  for (int x = 0; x < width; x += 8) {
    Floats squares = Floats{} + floor;
    for (int k = 0; k < levels.shots; ++k) {
      const Floats level = levelsOf(levels, k, x);
      squares += level * level;
    }
    const Floats scale = code_norm / rootOf(squares);
    for (int k = 0; k < levels.shots; k += 2) {
      const Ints even = roundedOf(scale * levelsOf(levels, k, x));
      const Ints odd =
          k + 1 < levels.shots ? roundedOf(scale * levelsOf(levels, k + 1, x)) : Ints{};
      store(codes + k / 2 * plane + x, (even & 0xffff) | (odd << 16));
    }
  }
}

template <int blocks>
ACMAP_INLINE void
correlateBytes(const ShotRows<std::int32_t>& reference,
               const ShotRows<std::int32_t>& target,
               int x,
               int first,
               std::uint8_t* costs)
{
  Ints sums[4 * blocks] = {};
  for (int pair = 0; pair < reference.shots; ++pair) {
    const Ints code = Ints{} + reference.values[pair * reference.plane + x];
    const std::int32_t* const codes = target.values + pair * target.plane + x + first;
    for (int i = 0; i < 4 * blocks; ++i)
      sums[i] += pairProducts(code, load<Ints>(codes + 8 * i));
  }
  for (int block = 0; block < blocks; ++block) {
    Ints block_costs[4];
    for (int i = 0; i < 4; ++i)
      block_costs[i] =
          (full_code + (1 << (code_shift - 1)) - sums[4 * block + i]) >> code_shift;
    const Bytes limit = Bytes{} + pcl::acmap::largest_byte_cost;
    store(costs + first + 32 * block, minimum(packedOf(block_costs), limit));
  }
}

void
correlate(const ShotRows<std::int32_t>& reference,
          const ShotRows<std::int32_t>& target,
          const ByteRow& costs)
{
  for (int x = 0; x < costs.width; ++x) {
    std::uint8_t* const at = costs.values + static_cast<std::int64_t>(x) * costs.stride;
    int first = 0;
    for (; first + 64 <= costs.stride; first += 64)
      correlateBytes<2>(reference, target, x, first, at);
    if (first < costs.stride)
      correlateBytes<1>(reference, target, x, first, at);
  }
}

} // namespace
