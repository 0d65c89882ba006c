// Eight floats, or eight or sixteen integers at once, as vector types of the compiler.
// To be included by source files only: everything is in an unnamed namespace, because
// every variant is compiled with its own flags.
#pragma once

#include <cstdint>

// The vectors are never passed between functions of different files.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace {

typedef float Floats __attribute__((vector_size(32), aligned(32)));
typedef std::int32_t Ints __attribute__((vector_size(32), aligned(32)));
typedef std::int16_t EightShorts __attribute__((vector_size(16), aligned(16)));
typedef std::int16_t Shorts __attribute__((vector_size(32), aligned(32)));
typedef std::uint16_t UnsignedShorts __attribute__((vector_size(32), aligned(32)));
typedef std::uint64_t Words __attribute__((vector_size(32), aligned(32)));

#define ACMAP_INLINE inline __attribute__((always_inline))

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

template <typename Vector>
ACMAP_INLINE Vector
minimum(const Vector& a, const Vector& b)
{
  return a < b ? a : b;
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
