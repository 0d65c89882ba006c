// Costs of a row, compiled once for each variant; included in the same way as lanes.h.
#pragma once

#include "lanes.h"
#include "pair_kernels.h"

#include <algorithm>

namespace {

using pcl::acmap::CostRow;
using pcl::acmap::largest_cost;
using pcl::acmap::ShotRows;
using pcl::acmap::WindowRow;

ACMAP_INLINE EightShorts
costsOf(const Floats& correlation, float scale)
{
  Floats cost = scale - scale * correlation;
  cost = cost < 0.0F ? Floats{} : cost;
  cost = cost > static_cast<float>(largest_cost) ? Floats{} + largest_cost : cost;
  return __builtin_convertvector(__builtin_convertvector(cost + 0.5F, Ints),
                                 EightShorts);
}

void
addProducts(const ShotRows<std::int16_t>& reference,
            const ShotRows<std::int16_t>& target,
            int width,
            int stride,
            int sign,
            std::int32_t* sums)
{
  for (int x = 0; x < width; ++x)
    for (int i = 0; i < stride; i += 8) {
      std::int32_t* const at = sums + static_cast<std::int64_t>(x) * stride + i;
      Ints sum = load<Ints>(at);
      for (int k = 0; k < reference.shots; ++k)
        sum += sign * static_cast<int>(reference.values[k * reference.plane + x]) *
               widened(load<EightShorts>(target.values + k * target.plane + x + i));
      store(at, sum);
    }
}

void
correlateWindows(const std::int32_t* sums,
                 int radius,
                 const WindowRow& reference,
                 const WindowRow& target,
                 float scale,
                 const CostRow& costs)
{
  const std::int64_t stride = costs.stride;
  for (int i = 0; i < costs.stride; i += 8) {
    Ints sum{};
    for (int x = 0; x < 2 * radius; ++x)
      sum += load<Ints>(sums + x * stride + i);
    for (int x = 0; x < costs.width; ++x) {
      sum += load<Ints>(sums + (x + 2 * radius) * stride + i);
      const Floats means = reference.mean[x] * load<Floats>(target.mean + x + i);
      const Floats norms =
          reference.inverse_norm[x] * load<Floats>(target.inverse_norm + x + i);
      const Floats correlation = (__builtin_convertvector(sum, Floats) - means) * norms;
      store(costs.values + x * stride + i, costsOf(correlation, scale));
      sum -= load<Ints>(sums + x * stride + i);
    }
  }
}

ACMAP_INLINE Words
bitsOf(Words word)
{
  word -= (word >> 1) & 0x5555555555555555U;
  word = (word & 0x3333333333333333U) + ((word >> 2) & 0x3333333333333333U);
  word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fU;
  word += word >> 8;
  word += word >> 16;
  word += word >> 32;
  return word & 0x7fU;
}

void
countBits(const ShotRows<std::uint64_t>& reference,
          const ShotRows<std::uint64_t>& target,
          std::int16_t cost_of_bit,
          const CostRow& costs)
{
  for (int x = 0; x < costs.width; ++x)
    for (int i = 0; i < costs.stride; i += 4) {
      Words bits{};
      for (int k = 0; k < reference.shots; ++k)
        bits += bitsOf(load<Words>(target.values + k * target.plane + x + i) ^
                       reference.values[k * reference.plane + x]);
      std::int16_t* const at =
          costs.values + static_cast<std::int64_t>(x) * costs.stride + i;
      for (int j = 0; j < 4; ++j)
        at[j] = static_cast<std::int16_t>(
            std::min(static_cast<int>(bits[j]) * cost_of_bit, int{largest_cost}));
    }
}

} // namespace
