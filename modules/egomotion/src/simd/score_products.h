// Products of patches, compiled once for each variant; to be included by source files
// only.
#pragma once

#include "score_kernels.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

// The vectors are never passed between functions of different files.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace {

using pcl::acmap::score_columns;
using pcl::acmap::score_rows;
using pcl::acmap::ScoreFactors;

#define ACMAP_INLINE inline __attribute__((always_inline))

typedef std::int32_t Sums __attribute__((vector_size(32), aligned(32)));

/** Adds, for each of eight columns, the product of its pair with the pair of the row.
 */
ACMAP_INLINE void
addPairs(const std::int16_t* row, const std::int16_t* columns, Sums& sums)
{
#if defined(__AVX2__)
  std::int32_t pair;
  __builtin_memcpy(&pair, row, sizeof pair);
  const __m256i others = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(columns));
  sums += (Sums)_mm256_madd_epi16(_mm256_set1_epi32(pair), others);
#elif defined(__SSE2__)
  typedef std::int32_t Half __attribute__((vector_size(16), aligned(16)));
  std::int32_t pair;
  __builtin_memcpy(&pair, row, sizeof pair);
  const auto* const others = reinterpret_cast<const __m128i*>(columns);
  Half halves[2];
  __builtin_memcpy(halves, &sums, sizeof sums);
  for (int k = 0; k < 2; ++k)
    halves[k] +=
        (Half)_mm_madd_epi16(_mm_set1_epi32(pair), _mm_loadu_si128(others + k));
  __builtin_memcpy(&sums, halves, sizeof sums);
#else
  for (std::size_t j = 0; j < score_columns; ++j)
    sums[j] += row[0] * columns[2 * j] + row[1] * columns[2 * j + 1];
#endif
}

ACMAP_INLINE void
raise(std::int32_t* scores, const Sums& sums)
{
  Sums before;
  __builtin_memcpy(&before, scores, sizeof before);
  before = sums > before ? sums : before;
  __builtin_memcpy(scores, &before, sizeof before);
}

/** Multiplies four rows by several blocks of eight columns, so that loaded values are
 * reused. */
template <std::size_t blocks>
ACMAP_INLINE void
raiseBlocks(const ScoreFactors& factors,
            const std::int16_t* columns,
            std::int32_t* scores)
{
  const std::size_t length = 2 * factors.pairs;
  Sums sums[score_rows][blocks] = {};
  for (std::size_t k = 0; k < length; k += 2)
    for (std::size_t block = 0; block < blocks; ++block)
      for (std::size_t i = 0; i < score_rows; ++i)
        addPairs(factors.rows + i * length + k,
                 columns + score_columns * (block * length + k),
                 sums[i][block]);
  for (std::size_t i = 0; i < score_rows; ++i)
    for (std::size_t block = 0; block < blocks; ++block)
      raise(scores + score_columns * (i * factors.column_blocks + block),
            sums[i][block]);
}

void
raiseAll(const ScoreFactors& factors, std::int32_t* scores)
{
#if defined(__AVX2__)
  constexpr std::size_t at_once = 2; // limited by the number of registers
#else
  constexpr std::size_t at_once = 1;
#endif
  const std::size_t size = score_columns * 2 * factors.pairs;
  std::size_t block = 0;
  for (; block + at_once <= factors.column_blocks; block += at_once)
    raiseBlocks<at_once>(
        factors, factors.columns + block * size, scores + block * score_columns);
  for (; block < factors.column_blocks; ++block)
    raiseBlocks<1>(
        factors, factors.columns + block * size, scores + block * score_columns);
}

} // namespace
