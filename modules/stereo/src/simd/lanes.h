// Vectors of smaller integers than those of core.
#pragma once

#include <pcl/core/impl/lanes.h>

#include <cmath>

namespace {

typedef std::int16_t EightShorts __attribute__((vector_size(16), aligned(16)));
typedef std::int16_t Shorts __attribute__((vector_size(32), aligned(32)));
typedef std::uint16_t UnsignedShorts __attribute__((vector_size(32), aligned(32)));
typedef std::uint8_t Bytes __attribute__((vector_size(32), aligned(32)));
typedef std::uint8_t SixteenBytes __attribute__((vector_size(16), aligned(16)));
typedef std::uint64_t Words __attribute__((vector_size(32), aligned(32)));

template <typename Vector>
ACMAP_INLINE Vector
minimum(const Vector& a, const Vector& b)
{
  return a < b ? a : b;
}

/** Square roots are rounded correctly by every instruction set. */
ACMAP_INLINE Floats
rootOf(const Floats& v)
{
  Floats root;
#if defined(__AVX__)
  root = (Floats)_mm256_sqrt_ps((__m256)v);
#elif defined(__SSE2__)
  const float* const from = reinterpret_cast<const float*>(&v);
  float* const to = reinterpret_cast<float*>(&root);
  _mm_storeu_ps(to, _mm_sqrt_ps(_mm_loadu_ps(from)));
  _mm_storeu_ps(to + 4, _mm_sqrt_ps(_mm_loadu_ps(from + 4)));
#else
  for (int i = 0; i < 8; ++i)
    root[i] = std::sqrt(v[i]);
#endif
  return root;
}

ACMAP_INLINE Ints
widened(const EightShorts& v)
{
#if defined(__AVX2__)
  return (Ints)_mm256_cvtepi16_epi32((__m128i)v);
#else
  return __builtin_convertvector(v, Ints);
#endif
}

/** Integers as bytes, limited to their range. */
ACMAP_INLINE Bytes
packedOf(const Ints (&v)[4])
{
#if defined(__AVX2__)
  const __m256i low = _mm256_packs_epi32((__m256i)v[0], (__m256i)v[1]);
  const __m256i high = _mm256_packs_epi32((__m256i)v[2], (__m256i)v[3]);
  const __m256i order = _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7);
  return (Bytes)_mm256_permutevar8x32_epi32(_mm256_packus_epi16(low, high), order);
#else
  Bytes bytes;
  for (int i = 0; i < 32; ++i) {
    const std::int32_t value = v[i / 8][i % 8];
    bytes[i] = static_cast<std::uint8_t>(value < 0 ? 0 : value > 255 ? 255 : value);
  }
  return bytes;
#endif
}

/** The last byte of one vector, and all but the last of the next. */
ACMAP_INLINE Bytes
lastAnd(const Bytes& before, const Bytes& v)
{
  return __builtin_shufflevector(before,
                                 v,
                                 31,
                                 32,
                                 33,
                                 34,
                                 35,
                                 36,
                                 37,
                                 38,
                                 39,
                                 40,
                                 41,
                                 42,
                                 43,
                                 44,
                                 45,
                                 46,
                                 47,
                                 48,
                                 49,
                                 50,
                                 51,
                                 52,
                                 53,
                                 54,
                                 55,
                                 56,
                                 57,
                                 58,
                                 59,
                                 60,
                                 61,
                                 62);
}

/** All but the first byte of one vector, and the first of the next. */
ACMAP_INLINE Bytes
firstBehind(const Bytes& v, const Bytes& behind)
{
  return __builtin_shufflevector(v,
                                 behind,
                                 1,
                                 2,
                                 3,
                                 4,
                                 5,
                                 6,
                                 7,
                                 8,
                                 9,
                                 10,
                                 11,
                                 12,
                                 13,
                                 14,
                                 15,
                                 16,
                                 17,
                                 18,
                                 19,
                                 20,
                                 21,
                                 22,
                                 23,
                                 24,
                                 25,
                                 26,
                                 27,
                                 28,
                                 29,
                                 30,
                                 31,
                                 32);
}

ACMAP_INLINE Bytes
spreadFirst(const Bytes& v)
{
#if defined(__AVX2__)
  return (Bytes)_mm256_broadcastb_epi8(_mm256_castsi256_si128((__m256i)v));
#else
  return Bytes{} + v[0];
#endif
}

/** The minima of four vectors, in the bytes 0, 8, 16 and 24. */
ACMAP_INLINE Bytes
leastOfFour(const Bytes (&v)[4])
{
  const auto halves = [](const Words& a, const Words& b) {
    return (Words)minimum((Bytes)__builtin_shufflevector(a, b, 0, 1, 4, 5),
                          (Bytes)__builtin_shufflevector(a, b, 2, 3, 6, 7));
  };
  const Words a = halves((Words)v[0], (Words)v[2]),
              b = halves((Words)v[1], (Words)v[3]);
  Words least = (Words)minimum((Bytes)__builtin_shufflevector(a, b, 0, 4, 2, 6),
                               (Bytes)__builtin_shufflevector(a, b, 1, 5, 3, 7));
  for (int bits = 32; bits >= 8; bits /= 2)
    least = (Words)minimum((Bytes)least, (Bytes)(least >> bits));
  return (Bytes)least;
}

ACMAP_INLINE std::int16_t
leastOf(Shorts v)
{
  v = minimum(v,
              __builtin_shufflevector(
                  v, v, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
  v = minimum(v,
              __builtin_shufflevector(
                  v, v, 4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11));
  v = minimum(v,
              __builtin_shufflevector(
                  v, v, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13));
  v = minimum(v,
              __builtin_shufflevector(
                  v, v, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14));
  return v[0];
}

} // namespace
