// Loops over the pixels of images, compiled once for each variant; included in the same
// way as lanes.h.
#pragma once

#include "image_kernels.h"
#include "lanes.h"

namespace {

#ifdef __SSSE3__
/** One channel of sixteen pixels, whose bytes are in three vectors. */
template <int channel>
ACMAP_INLINE UnsignedShorts
channelOf(const SixteenBytes& first,
          const SixteenBytes& second,
          const SixteenBytes& third)
{
  // The pixel i is the byte 3 i + channel; from the last vector on, at or above 32.
  constexpr auto early = [](int i) { return (3 * i + channel) % 32; };
  constexpr auto late = [](int i) {
    return 3 * i + channel < 32 ? i : 16 + 3 * i + channel - 32;
  };
  const SixteenBytes most = __builtin_shufflevector(first,
                                                    second,
                                                    early(0),
                                                    early(1),
                                                    early(2),
                                                    early(3),
                                                    early(4),
                                                    early(5),
                                                    early(6),
                                                    early(7),
                                                    early(8),
                                                    early(9),
                                                    early(10),
                                                    early(11),
                                                    early(12),
                                                    early(13),
                                                    early(14),
                                                    early(15));
  const SixteenBytes all = __builtin_shufflevector(most,
                                                   third,
                                                   late(0),
                                                   late(1),
                                                   late(2),
                                                   late(3),
                                                   late(4),
                                                   late(5),
                                                   late(6),
                                                   late(7),
                                                   late(8),
                                                   late(9),
                                                   late(10),
                                                   late(11),
                                                   late(12),
                                                   late(13),
                                                   late(14),
                                                   late(15));
  return __builtin_convertvector(all, UnsignedShorts);
}
#endif

void
toGrey(const std::uint8_t* colors, int count, std::int16_t* grey)
{
  int i = 0;
#ifdef __SSSE3__
  for (; i + 16 <= count; i += 16) {
    const auto first = load<SixteenBytes>(colors + 3 * i);
    const auto second = load<SixteenBytes>(colors + 3 * i + 16);
    const auto third = load<SixteenBytes>(colors + 3 * i + 32);
    const UnsignedShorts sum = 77 * channelOf<0>(first, second, third) +
                               150 * channelOf<1>(first, second, third) +
                               29 * channelOf<2>(first, second, third) + 8;
    store(grey + i, sum >> 4);
  }
#endif
  for (; i < count; ++i) {
    const std::uint8_t* const color = colors + 3 * i;
    grey[i] = static_cast<std::int16_t>(
        (77 * color[0] + 150 * color[1] + 29 * color[2] + 8) / 16);
  }
}

/** The weighted mean, rounded. */
template <typename Value>
ACMAP_INLINE Value
blurred(const float* weights, const Value& middle, const Value& near, const Value& far)
{
  return (weights[0] * middle + weights[1] * near + weights[2] * far + 512.0F) *
         (1.0F / 1024.0F);
}

void
blurAlong(const float* levels, int width, const float* weights, float* out)
{
  int x = 0;
  for (; x + 8 <= width; x += 8) {
    const float* const at = levels + x;
    const Floats level = blurred<Floats>(weights,
                                         load<Floats>(at),
                                         load<Floats>(at - 1) + load<Floats>(at + 1),
                                         load<Floats>(at - 2) + load<Floats>(at + 2));
    store(out + x,
          __builtin_convertvector(__builtin_convertvector(level, Ints), Floats));
  }
  for (; x < width; ++x)
    out[x] =
        static_cast<float>(static_cast<int>(blurred(weights,
                                                    levels[x],
                                                    levels[x - 1] + levels[x + 1],
                                                    levels[x - 2] + levels[x + 2])));
}

void
blurAcross(const float* const* rows, int width, const float* weights, std::int16_t* out)
{
  int x = 0;
  for (; x + 8 <= width; x += 8) {
    const Floats level =
        blurred<Floats>(weights,
                        load<Floats>(rows[2] + x),
                        load<Floats>(rows[1] + x) + load<Floats>(rows[3] + x),
                        load<Floats>(rows[0] + x) + load<Floats>(rows[4] + x));
    store(out + x,
          __builtin_convertvector(__builtin_convertvector(level, Ints), EightShorts));
  }
  for (; x < width; ++x)
    out[x] = static_cast<std::int16_t>(
        blurred(weights, rows[2][x], rows[1][x] + rows[3][x], rows[0][x] + rows[4][x]));
}

void
toFloats(const std::int16_t* from, int count, float* to)
{
  int i = 0;
  for (; i + 8 <= count; i += 8)
    store(to + i,
          __builtin_convertvector(widened(load<EightShorts>(from + i)), Floats));
  for (; i < count; ++i)
    to[i] = static_cast<float>(from[i]);
}

} // namespace
