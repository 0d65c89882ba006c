// Sums at quarter pixels, compiled once for each variant; included in the same way as
// lanes.h.
#pragma once

#include "lanes.h"
#include "pair_kernels.h"

namespace {

using pcl::acmap::SubPixelSums;
using pcl::acmap::WindowAtQuarters;

void
sumAtQuarters(const ShotRows<float>& pixel,
              const ShotRows<float>& target,
              SubPixelSums& sums)
{
  for (int half = 0; half < SubPixelSums::quarters; half += 8) {
    Floats products{}, squares{}, values{};
    for (int k = 0; k < pixel.shots; ++k) {
      const Floats value = load<Floats>(target.values + k * target.plane + half);
      products += pixel.values[k * pixel.plane] * value;
      squares += value * value;
      values += value;
    }
    store(sums.products + half, products);
    store(sums.squares + half, squares);
    store(sums.values + half, values);
  }
}

void
sumWindow(const float* const* pixels, int count, bool values, WindowAtQuarters& window)
{
  constexpr int next = SubPixelSums::quarters;
  Floats products{}, squares{}, levels{};
  for (int i = 0; i < count; ++i) {
    products += load<Floats>(pixels[i]);
    squares += load<Floats>(pixels[i] + next);
  }
  for (int i = 0; values && i < count; ++i)
    levels += load<Floats>(pixels[i] + 2 * next);
  store(window.products, products);
  store(window.squares, squares);
  store(window.values, levels);
}

} // namespace
