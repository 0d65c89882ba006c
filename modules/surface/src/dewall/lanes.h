// Eight floats as a vector type of the compiler.
#pragma once

#include "variant.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// The vectors are never passed between functions of different files.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace pcl::acmap::ACMAP_DEWALL {

typedef float Lanes __attribute__((vector_size(32), aligned(32)));
typedef int LaneMask __attribute__((vector_size(32), aligned(32)));

#define ACMAP_INLINE inline __attribute__((always_inline))

ACMAP_INLINE Lanes
loadLanes(const float* from)
{
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

ACMAP_INLINE Lanes
allLanes(float value)
{
  return Lanes{value, value, value, value, value, value, value, value};
}

ACMAP_INLINE LaneMask
loadIntegers(const int* from)
{
  LaneMask lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

ACMAP_INLINE LaneMask
allIntegers(int value)
{
  return LaneMask{value, value, value, value, value, value, value, value};
}

ACMAP_INLINE Lanes
maxLanes(const Lanes& a, const Lanes& b)
{
#if defined(ACMAP_DEWALL_AVX2)
  return _mm256_max_ps(a, b); // b where they cannot be compared, as below
#else
  return a > b ? a : b;
#endif
}

/** Returns a bit for each lane whose mask is set. */
ACMAP_INLINE unsigned
bitsOf(const LaneMask& mask)
{
#if defined(ACMAP_DEWALL_AVX2)
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#elif defined(__SSE2__)
  __m128 halves[2];
  __builtin_memcpy(halves, &mask, sizeof mask);
  return static_cast<unsigned>(_mm_movemask_ps(halves[0]) |
                               (_mm_movemask_ps(halves[1]) << 4));
#else
  unsigned bits = 0;
  for (int lane = 0; lane < 8; ++lane)
    bits |= (static_cast<unsigned>(mask[lane]) & 1u) << lane;
  return bits;
#endif
}

/** Is each of four numbers greater than the one at its place among four others? */
ACMAP_INLINE bool
areAllGreater(const float* four, const float* others)
{
#if defined(__SSE2__)
  return _mm_movemask_ps(_mm_cmpgt_ps(_mm_loadu_ps(four), _mm_loadu_ps(others))) == 0xf;
#else
  bool all = true;
  for (int lane = 0; lane < 4; ++lane)
    all &= four[lane] > others[lane];
  return all;
#endif
}

/** Returns a bit for each of four integers that equals a value. */
ACMAP_INLINE unsigned
bitsOfEqual(const int* four, int value)
{
#if defined(__SSE2__)
  const __m128i all = _mm_loadu_si128(reinterpret_cast<const __m128i*>(four));
  return static_cast<unsigned>(
      _mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(all, _mm_set1_epi32(value)))));
#else
  unsigned bits = 0;
  for (int lane = 0; lane < 4; ++lane)
    bits |= static_cast<unsigned>(four[lane] == value) << lane;
  return bits;
#endif
}

ACMAP_INLINE unsigned
lowestBit(unsigned bits)
{
  return static_cast<unsigned>(__builtin_ctz(bits));
}

/** Returns the lane with the smallest value among those whose bits are set, at least
 * one; none of them may be NaN. */
ACMAP_INLINE unsigned
smallestLane(const Lanes& values, unsigned lanes)
{
#if defined(ACMAP_DEWALL_AVX2)
  const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  const __m256i chosen = _mm256_cmpeq_epi32(
      _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(lanes)), bit), bit);
  const __m256 valid = _mm256_blendv_ps(
      _mm256_set1_ps(__builtin_inff()), values, _mm256_castsi256_ps(chosen));
  __m128 least =
      _mm_min_ps(_mm256_castps256_ps128(valid), _mm256_extractf128_ps(valid, 1));
  least = _mm_min_ps(least, _mm_movehl_ps(least, least));
  least = _mm_min_ss(least, _mm_movehdup_ps(least));
  const __m256 all = _mm256_broadcastss_ps(least);
  return lowestBit(static_cast<unsigned>(
                       _mm256_movemask_ps(_mm256_cmp_ps(values, all, _CMP_EQ_OQ))) &
                   lanes);
#else
  float each[8];
  __builtin_memcpy(each, &values, sizeof each);
  unsigned smallest = lowestBit(lanes);
  for (lanes &= lanes - 1; lanes; lanes &= lanes - 1)
    if (each[lowestBit(lanes)] < each[smallest])
      smallest = lowestBit(lanes);
  return smallest;
#endif
}

} // namespace pcl::acmap::ACMAP_DEWALL
