// Eight floats or integers at once, as vector types of the compiler. To be included by
// source files of kernels only: everything is in an unnamed namespace, because every
// variant is compiled with its own flags.
#pragma once

#include <cstdint>

#ifdef __SSE2__
#include <immintrin.h>
#endif

// The vectors are never passed between functions of different files.
#pragma GCC diagnostic ignored "-Wpsabi"

#define ACMAP_INLINE inline __attribute__((always_inline))

namespace {

typedef float Floats __attribute__((vector_size(32), aligned(32)));
typedef std::int32_t Ints __attribute__((vector_size(32), aligned(32)));

template <typename Vector, typename Value>
ACMAP_INLINE Vector
load(const Value* from)
{
  Vector vector;
  __builtin_memcpy(&vector, from, sizeof vector);
  return vector;
}

template <typename Vector, typename Value>
ACMAP_INLINE void
store(Value* to, const Vector& vector)
{
  __builtin_memcpy(to, &vector, sizeof vector);
}

/** The sum of the products of both halves of each integer, which are signed. */
ACMAP_INLINE Ints
pairProducts(const Ints& a, const Ints& b)
{
#if defined(__AVX2__)
  return (Ints)_mm256_madd_epi16((__m256i)a, (__m256i)b);
#elif defined(__SSE2__)
  Ints sums;
  const auto* const left = reinterpret_cast<const __m128i*>(&a);
  const auto* const right = reinterpret_cast<const __m128i*>(&b);
  auto* const to = reinterpret_cast<__m128i*>(&sums);
  _mm_store_si128(to, _mm_madd_epi16(left[0], right[0]));
  _mm_store_si128(to + 1, _mm_madd_epi16(left[1], right[1]));
  return sums;
#else
  return (a >> 16) * (b >> 16) + (a << 16 >> 16) * (b << 16 >> 16);
#endif
}

} // namespace
