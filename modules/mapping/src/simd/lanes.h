// Four doubles or floats, besides the vectors of core.
#pragma once

#include <pcl/core/impl/lanes.h>

namespace {

typedef double Lanes __attribute__((vector_size(32), aligned(32)));
typedef long long LaneInts __attribute__((vector_size(32), aligned(32)));
typedef unsigned long long LaneBits __attribute__((vector_size(32), aligned(32)));
typedef unsigned FloatBits __attribute__((vector_size(32), aligned(32)));
typedef float FourFloats __attribute__((vector_size(16), aligned(16)));
typedef unsigned FourBits __attribute__((vector_size(16), aligned(16)));

constexpr int lane_count = 4;

ACMAP_INLINE Lanes
lanesOf(const FourFloats& floats)
{
  return __builtin_convertvector(floats, Lanes);
}

ACMAP_INLINE FourFloats
floatsOf(const Lanes& lanes)
{
  return __builtin_convertvector(lanes, FourFloats);
}

ACMAP_INLINE Lanes
loadLanes(const float* from)
{
  return lanesOf(load<FourFloats>(from));
}

ACMAP_INLINE Floats
join(const FourFloats& low, const FourFloats& high)
{
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

ACMAP_INLINE FourFloats
lowOf(const Floats& floats)
{
  return __builtin_shufflevector(floats, floats, 0, 1, 2, 3);
}

ACMAP_INLINE FourFloats
highOf(const Floats& floats)
{
  return __builtin_shufflevector(floats, floats, 4, 5, 6, 7);
}

ACMAP_INLINE FourFloats
allFour(float value)
{
  return FourFloats{value, value, value, value};
}

ACMAP_INLINE Lanes
allLanes(double value)
{
  return Lanes{value, value, value, value};
}

/** Sum in the order of the lanes. */
ACMAP_INLINE double
sumOf(const Lanes& lanes)
{
  return ((lanes[0] + lanes[1]) + lanes[2]) + lanes[3];
}

ACMAP_INLINE void
transpose(FourFloats& a, FourFloats& b, FourFloats& c, FourFloats& d)
{
  const FourFloats ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const FourFloats ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const FourFloats cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const FourFloats cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

/** Transposes the low and the high halves separately. */
ACMAP_INLINE void
transpose(Floats& a, Floats& b, Floats& c, Floats& d)
{
  const Floats ab_low = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
  const Floats ab_high = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  const Floats cd_low = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
  const Floats cd_high = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 8, 9, 4, 5, 12, 13);
  b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 10, 11, 6, 7, 14, 15);
  c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15);
}

/** If this is added to a number below 2^51, no bits are left for fractions: the lowest
 * bits of the sum are the nearest integer. */
constexpr double rounder = 0x1.8p52;

ACMAP_INLINE Lanes
roundLanes(const Lanes& values)
{
  return (values + allLanes(rounder)) - allLanes(rounder);
}

/** Converts integers below 2^51. */
ACMAP_INLINE LaneInts
intsOf(const Lanes& integers)
{
  constexpr long long bits_of_rounder = 0x4338000000000000;
  return reinterpret_cast<LaneInts>(integers + allLanes(rounder)) - bits_of_rounder;
}

/** log2 of normal numbers with an error of 1e-14; finite for 0. The function of the C
 * library differs between processors. */
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

/** log2 of normal numbers with an error of 2e-7 times the larger of it and 1; 0 for 0.
 * \a Bits are integers of the same width as the vector. */
template <typename Bits, typename Vector>
ACMAP_INLINE Vector
log2Floats(const Vector& values)
{
  constexpr unsigned one = 0x3f800000, root_half = 0x3f3504f3, fraction = 0x007fffff,
                     two_23 = 0x4b000000;
  const Bits biased = reinterpret_cast<Bits>(values) + (one - root_half);
  const Vector exponent =
      reinterpret_cast<Vector>((biased >> 23) | two_23) - (0x1p23F + 127);
  const Vector m = reinterpret_cast<Vector>((biased & fraction) + root_half);
  const Vector t = (m - 1) / (m + 1);
  const Vector t2 = t * t;
  constexpr float scale = 2.8853900817779268F; // 2 / ln 2
  const Vector sum = ((scale / 7 * t2 + scale / 5) * t2 + scale / 3) * t2 + scale;
  return reinterpret_cast<Vector>(reinterpret_cast<Bits>(exponent + t * sum) &
                                  reinterpret_cast<Bits>(values > 0));
}

} // namespace
