// Products of patches, compiled once for each variant; to be included by source files
// only.
#pragma once

#include "score_kernels.h"

#include <pcl/core/impl/lanes.h>

namespace {

using pcl::acmap::score_columns;
using pcl::acmap::score_rows;
using pcl::acmap::ScoreFactors;

/** Adds, for each of eight columns, the product of its pair with the pair of the row.
 */
ACMAP_INLINE void
addPairs(const std::int16_t* row, const std::int16_t* columns, Ints& sums)
{
  sums += pairProducts(Ints{} + load<std::int32_t>(row), load<Ints>(columns));
}

/** One bit per column: whether its sum is at least the minimum. */
ACMAP_INLINE std::uint8_t
bitsOf(const Ints& sums, std::int32_t minimum)
{
  const Ints is_found = sums >= minimum; // -1 or 0
#if defined(__AVX2__)
  return static_cast<std::uint8_t>(_mm256_movemask_ps((__m256)is_found));
#else
  int bits = 0;
  for (std::size_t j = 0; j < score_columns; ++j)
    bits |= is_found[j] & 1 << j;
  return static_cast<std::uint8_t>(bits);
#endif
}

/** Multiplies four rows by several blocks of eight columns, so that loaded values are
 * reused. */
template <std::size_t blocks>
ACMAP_INLINE void
findInBlocks(const ScoreFactors& factors,
             const std::int16_t* columns,
             std::int32_t minimum,
             std::uint8_t* found)
{
  const std::size_t length = 2 * factors.pairs;
  Ints sums[score_rows][blocks] = {};
  for (std::size_t k = 0; k < length; k += 2)
    for (std::size_t block = 0; block < blocks; ++block)
      for (std::size_t i = 0; i < score_rows; ++i)
        addPairs(factors.rows + i * length + k,
                 columns + score_columns * (block * length + k),
                 sums[i][block]);
  for (std::size_t i = 0; i < score_rows; ++i)
    for (std::size_t block = 0; block < blocks; ++block)
      found[i * factors.column_blocks + block] = bitsOf(sums[i][block], minimum);
}

void
findAll(const ScoreFactors& factors, std::int32_t minimum, std::uint8_t* found)
{
#if defined(__AVX2__)
  constexpr std::size_t at_once = 2; // limited by the number of registers
#else
  constexpr std::size_t at_once = 1;
#endif
  const std::size_t size = score_columns * 2 * factors.pairs;
  std::size_t block = 0;
  for (; block + at_once <= factors.column_blocks; block += at_once)
    findInBlocks<at_once>(
        factors, factors.columns + block * size, minimum, found + block);
  for (; block < factors.column_blocks; ++block)
    findInBlocks<1>(factors, factors.columns + block * size, minimum, found + block);
}

std::int32_t
productOfAll(const std::int16_t* a, const std::int16_t* b, std::size_t length)
{
  Ints sums = {};
  for (std::size_t k = 0; k < length; k += pcl::acmap::score_samples)
    sums += pairProducts(load<Ints>(a + k), load<Ints>(b + k));
  std::int32_t sum = 0;
  for (std::size_t k = 0; k < score_columns; ++k)
    sum += sums[k];
  return sum;
}

} // namespace
