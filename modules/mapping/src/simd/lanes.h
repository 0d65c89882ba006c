// Four doubles at once, as a vector type of the compiler. For the inside of one source
// file: all is in an unnamed namespace, since every variant is compiled with its own flags.
#pragma once

// The vectors never pass between functions of different files.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace {

typedef double Lanes __attribute__((vector_size(32), aligned(32)));
typedef long long LaneInts __attribute__((vector_size(32), aligned(32)));
typedef unsigned long long LaneBits __attribute__((vector_size(32), aligned(32)));

#define ACMAP_INLINE inline __attribute__((always_inline))

constexpr int lane_count = 4;

ACMAP_INLINE Lanes
loadLanes(const double* from)
{
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

ACMAP_INLINE Lanes
loadLanes(const float* from)
{
  typedef float Floats __attribute__((vector_size(16)));
  Floats floats;
  __builtin_memcpy(&floats, from, sizeof floats);
  return __builtin_convertvector(floats, Lanes);
}

ACMAP_INLINE void
storeLanes(double* to, const Lanes& lanes)
{
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

ACMAP_INLINE Lanes
allLanes(double value)
{
  return Lanes{value, value, value, value};
}

/** In the order of the lanes. */
ACMAP_INLINE double
sumOf(const Lanes& lanes)
{
  return ((lanes[0] + lanes[1]) + lanes[2]) + lanes[3];
}

ACMAP_INLINE void
transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d)
{
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/** Added to a number below 2^51 it leaves no bits for fractions: the sum's lowest bits
 * are the nearest integer. */
constexpr double rounder = 0x1.8p52;

ACMAP_INLINE Lanes
roundLanes(const Lanes& values)
{
  return (values + allLanes(rounder)) - allLanes(rounder);
}

/** Of integers below 2^51. */
ACMAP_INLINE LaneInts
intsOf(const Lanes& integers)
{
  constexpr long long bits_of_rounder = 0x4338000000000000;
  return reinterpret_cast<LaneInts>(integers + allLanes(rounder)) - bits_of_rounder;
}

/** log2 of normal numbers to 1e-14; of 0 something finite. The C library's own differs
 * between processors. */
ACMAP_INLINE Lanes
log2Lanes(const Lanes& values)
{
  // value = 2^e m with m in [sqrt 1/2, sqrt 2); ln m = 2 artanh ((m - 1) / (m + 1)).
  constexpr unsigned long long one = 0x3ff0000000000000, root_half = 0x3fe6a09e667f3bcd,
                               fraction = 0x000fffffffffffff,
                               two_52 = 0x4330000000000000;
  const LaneBits biased = reinterpret_cast<LaneBits>(values) + (one - root_half);
  const Lanes exponent =
      reinterpret_cast<Lanes>((biased >> 52) | two_52) - allLanes(0x1p52 + 1023);
  const Lanes m = reinterpret_cast<Lanes>((biased & fraction) + root_half);
  const Lanes t = (m - allLanes(1)) / (m + allLanes(1));
  const Lanes t2 = t * t;
  constexpr double scale = 2.8853900817779268; // 2 / ln 2
  Lanes sum = allLanes(scale / 17);
  for (int odd = 15; odd >= 1; odd -= 2)
    sum = sum * t2 + allLanes(scale / odd);
  return exponent + t * sum;
}

} // namespace
