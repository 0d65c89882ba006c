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

/** One bit per column: whether its sum is at least the minimum. */
ACMAP_INLINE std::uint8_t
bitsOf(const Sums& sums, std::int32_t minimum)
{
  const Sums is_found = sums >= minimum; // -1 or 0
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
  Sums sums[score_rows][blocks] = {};
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

/** The sum of the products of eight pairs, in eight parts. */
ACMAP_INLINE void
addProducts(const std::int16_t* a, const std::int16_t* b, Sums& sums)
{
#if defined(__AVX2__)
  sums +=
      (Sums)_mm256_madd_epi16(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(a)),
                              _mm256_loadu_si256(reinterpret_cast<const __m256i*>(b)));
#elif defined(__SSE2__)
  typedef std::int32_t Half __attribute__((vector_size(16), aligned(16)));
  const auto *const first = reinterpret_cast<const __m128i*>(a),
                    *const second = reinterpret_cast<const __m128i*>(b);
  Half halves[2];
  __builtin_memcpy(halves, &sums, sizeof sums);
  for (int k = 0; k < 2; ++k)
    halves[k] +=
        (Half)_mm_madd_epi16(_mm_loadu_si128(first + k), _mm_loadu_si128(second + k));
  __builtin_memcpy(&sums, halves, sizeof sums);
#else
  for (std::size_t k = 0; k < score_columns; ++k)
    sums[k] += a[2 * k] * b[2 * k] + a[2 * k + 1] * b[2 * k + 1];
#endif
}

std::int32_t
productOfAll(const std::int16_t* a, const std::int16_t* b, std::size_t length)
{
  Sums sums = {};
  for (std::size_t k = 0; k < length; k += pcl::acmap::score_samples)
    addProducts(a + k, b + k, sums);
  std::int32_t sum = 0;
  for (std::size_t k = 0; k < score_columns; ++k)
    sum += sums[k];
  return sum;
}

} // namespace
