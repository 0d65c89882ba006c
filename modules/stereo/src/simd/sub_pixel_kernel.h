// Sums and correlations at quarter pixels, compiled once for each variant; included in
// the same way as lanes.h.
#pragma once

#include "cubic_weights.h"
#include "lanes.h"
#include "pair_kernels.h"

namespace {

using pcl::acmap::cubic_weights;
using pcl::acmap::LevelSums;
using pcl::acmap::MatchedRow;
using pcl::acmap::WindowMatch;
using pcl::acmap::WindowTerms;

void
sumProducts(const ShotRows<float>& reference,
            const ShotRows<float>& target,
            int width,
            const int* shifts,
            float* products)
{
  for (int x = 0; x < width; ++x) {
    Floats sum{};
    if (shifts[x] != MatchedRow::outside) {
      const float* const levels = target.values + x + shifts[x] - MatchedRow::before;
      for (int k = 0; k < reference.shots; ++k)
        sum += reference.values[k * reference.plane + x] *
               load<Floats>(levels + k * target.plane);
    }
    store(products + MatchedRow::products_of_pixel * x, sum);
  }
}

/** Sums of the pixels' own levels. */
void
sumLevels(const ShotRows<float>& reference,
          int width,
          bool values,
          const LevelSums& sums)
{
  for (int x = 0; x < width; x += 8) {
    Floats squares{}, levels{};
    for (int k = 0; k < reference.shots; ++k) {
      const Floats level = load<Floats>(reference.values + k * reference.plane + x);
      squares += level * level;
      levels += level;
    }
    store(sums.squares + x, squares);
    if (values)
      store(sums.values + x, levels);
  }
}

/** Stores sums of eight pixels at each quarter, pixel by pixel. */
ACMAP_INLINE void
storeQuarters(const Floats (&sums)[4], float* to)
{
  for (int lane = 0; lane < 8; ++lane)
    for (int quarter = 0; quarter < 4; ++quarter)
      to[4 * lane + quarter] = sums[quarter][lane];
}

/** Sums of levels that are interpolated at the quarters of eight columns. */
void
sumQuarters(const ShotRows<float>& target,
            int width,
            bool values,
            const LevelSums& sums)
{
  for (int x = 0; x < width; x += 8) {
    Floats squares[4] = {}, levels[4] = {};
    for (int k = 0; k < target.shots; ++k) {
      const float* const at = target.values + k * target.plane + x;
      const Floats before = load<Floats>(at - 1), here = load<Floats>(at),
                   behind = load<Floats>(at + 1), next = load<Floats>(at + 2);
      for (int quarter = 0; quarter < 4; ++quarter) {
        const Floats level =
            cubic_weights[0][quarter] * before + cubic_weights[1][quarter] * here +
            cubic_weights[2][quarter] * behind + cubic_weights[3][quarter] * next;
        squares[quarter] += level * level;
        levels[quarter] += level;
      }
    }
    storeQuarters(squares, sums.squares + 4 * x);
    if (values)
      storeQuarters(levels, sums.values + 4 * x);
  }
}

/** Sums over the pixel and two on either side, which are \a step values apart. */
void
sumFive(const float* values, int count, int step, float* sums)
{
  for (int i = 0; i < count; i += 8) {
    const float* const at = values + i;
    store(sums + i,
          load<Floats>(at - 2 * step) + load<Floats>(at - step) + load<Floats>(at) +
              load<Floats>(at + step) + load<Floats>(at + 2 * step));
  }
}

/** Sums over a window. */
struct WindowTotals {
  Floats products{}; ///< at whole pixels from -2 on
  Floats squares{}, values{};
  float own_squares = 0, own_values = 0;
  int pixels = 0;
};

/** Adds the five pixels of a row whose shifts differ by at most 1. */
template <bool centred>
ACMAP_INLINE void
addRow(const MatchedRow& row, int x, int shift, WindowTotals& totals)
{
  const auto addProducts = [&](const float* products, int pixel) {
    totals.products += load<Floats>(products + MatchedRow::products_of_pixel * pixel +
                                    shift - row.shifts[pixel] + 1);
  };
  if (row.least[x] >= shift - 1 && row.greatest[x] <= shift + 1) {
    if (row.least[x] == row.greatest[x])
      addProducts(row.products_of_five, x);
    else
      for (int pixel = x - 2; pixel <= x + 2; ++pixel)
        addProducts(row.products, pixel);
    const int quarter = 4 * (x + shift) - 4;
    totals.squares += load<Floats>(row.target.squares_of_five + quarter);
    totals.own_squares += row.reference.squares_of_five[x];
    if (!centred) {
      totals.values += load<Floats>(row.target.values_of_five + quarter);
      totals.own_values += row.reference.values_of_five[x];
    }
    totals.pixels += 5;
    return;
  }
  // At edges and in noise the processor could not predict branches: what does not belong
  // to the window is read from where there are zeros.
  for (int pixel = x - 2; pixel <= x + 2; ++pixel) {
    const int difference = shift - row.shifts[pixel];
    const bool belongs = difference >= -1 && difference <= 1;
    const int product = MatchedRow::products_of_pixel * pixel + difference + 1;
    const int quarter = 4 * (pixel + shift) - 4;
    totals.products +=
        load<Floats>(row.products + (belongs ? product : MatchedRow::zeros));
    const int target = belongs ? quarter : MatchedRow::target_zeros;
    totals.squares += load<Floats>(row.target.squares + target);
    const int own = belongs ? pixel : MatchedRow::own_zeros;
    totals.own_squares += row.reference.squares[own];
    if (!centred) {
      totals.values += load<Floats>(row.target.values + target);
      totals.own_values += row.reference.values[own];
    }
    totals.pixels += belongs ? 1 : 0;
  }
}

/** Interpolates sums of products: those of interpolated levels, as products are linear
 * in them. */
ACMAP_INLINE Floats
productsAtQuarters(const Floats& sums)
{
  const auto weights = [](int tap) {
    const auto& of_tap = cubic_weights[tap];
    return Floats{of_tap[0],
                  of_tap[1],
                  of_tap[2],
                  of_tap[3],
                  of_tap[0],
                  of_tap[1],
                  of_tap[2],
                  of_tap[3]};
  };
  return weights(0) * __builtin_shufflevector(sums, sums, 0, 0, 0, 0, 1, 1, 1, 1) +
         weights(1) * __builtin_shufflevector(sums, sums, 1, 1, 1, 1, 2, 2, 2, 2) +
         weights(2) * __builtin_shufflevector(sums, sums, 2, 2, 2, 2, 3, 3, 3, 3) +
         weights(3) * __builtin_shufflevector(sums, sums, 3, 3, 3, 3, 4, 4, 4, 4);
}

template <bool centred>
ACMAP_INLINE void
correlateTotals(const WindowTotals& totals,
                const WindowTerms& terms,
                WindowMatch& match)
{
  const float size = static_cast<float>(totals.pixels * terms.shots);
  const float floor = size * terms.noise_floor;
  const float own_mean = centred ? 0.0F : totals.own_values / size;
  const float own_square = totals.own_squares - size * own_mean * own_mean;
  const float own = own_square < 0.0F ? 0.0F : own_square;
  Floats square = totals.squares, product = productsAtQuarters(totals.products);
  if (!centred) {
    const Floats mean = totals.values / size;
    square -= size * mean * mean;
    product -= size * mean * own_mean;
  }
  square = square < 0.0F ? Floats{} : square;
  store(match.correlation, product / rootOf((own + floor) * (square + floor)));
  match.variance = own / size;
  match.size = size;
}

template <bool centred>
void
correlatePixels(const MatchedRow* const* rows,
                int count,
                const MatchedRow& middle,
                const WindowTerms& terms,
                WindowMatch* matches)
{
  for (int x = 0; x < terms.width; ++x) {
    const int shift = middle.shifts[x];
    if (shift == MatchedRow::outside)
      continue;
    WindowTotals totals;
    for (int row = 0; row < count; ++row)
      addRow<centred>(*rows[row], x, shift, totals);
    correlateTotals<centred>(totals, terms, matches[x]);
  }
}

void
correlateAround(const MatchedRow* const* rows,
                int count,
                const MatchedRow& middle,
                const WindowTerms& terms,
                WindowMatch* matches)
{
  if (terms.centred)
    correlatePixels<true>(rows, count, middle, terms, matches);
  else
    correlatePixels<false>(rows, count, middle, terms, matches);
}

} // namespace
