#include "kernel_variants.h"

#include "simd/cubic_weights.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace pcl::acmap::test {
namespace {

#ifdef ACMAP_SIMD_AVX2

class PairKernelVariants : public KernelVariants {
protected:
  /** Compares the costs that the variants write. */
  template <typename Run>
  static void
  expectSameCosts(std::size_t width, std::size_t stride, const Run& run)
  {
    const auto costsOf = [&](const PairKernels& kernels) {
      std::vector<std::int16_t> costs(width * stride + 1, 77);
      run(kernels,
          CostRow{costs.data(), static_cast<int>(width), static_cast<int>(stride)});
      EXPECT_EQ(costs.back(), 77) << "written beyond the row";
      return costs;
    };
    ASSERT_EQ(costsOf(pair_kernels_avx2), costsOf(pair_kernels_base))
        << width << " x " << stride;
  }
};

TEST_F(PairKernelVariants, CountBits)
{
  forSizes([](Draw& draw, std::size_t width, std::size_t stride, std::size_t shots) {
    const auto reference = draw.words(width * shots);
    const auto target = draw.words((width + stride) * shots);
    expectSameCosts(
        width, stride, [&](const PairKernels& kernels, const CostRow& costs) {
          kernels.countBits(rowsOf(reference, width, shots),
                            rowsOf(target, width + stride, shots),
                            20,
                            costs);
        });
  });
}

TEST_F(PairKernelVariants, AddProducts)
{
  forSizes([](Draw& draw, std::size_t width, std::size_t stride, std::size_t shots) {
    const auto reference = draw.integers<std::int16_t>(width * shots, -8000, 8000);
    const auto target =
        draw.integers<std::int16_t>((width + stride) * shots, -8000, 8000);
    const auto before = draw.integers<std::int32_t>(width * stride, -1e6, 1e6);
    for (const int sign : {1, -1}) {
      const auto sumsOf = [&](const PairKernels& kernels) {
        auto sums = before;
        kernels.addProducts(rowsOf(reference, width, shots),
                            rowsOf(target, width + stride, shots),
                            static_cast<int>(width),
                            static_cast<int>(stride),
                            sign,
                            sums.data());
        return sums;
      };
      ASSERT_EQ(sumsOf(pair_kernels_avx2), sumsOf(pair_kernels_base));
    }
  });
}

TEST_F(PairKernelVariants, CorrelateWindows)
{
  forSizes([](Draw& draw, std::size_t width, std::size_t stride, std::size_t shots) {
    const std::size_t radius = shots % 3;
    const auto sums =
        draw.integers<std::int32_t>((width + 2 * radius) * stride, -1e6, 1e6);
    const auto means = draw.floats(width), norms = draw.floats(width),
               target_means = draw.floats(width + stride),
               target_norms = draw.floats(width + stride);
    expectSameCosts(
        width, stride, [&](const PairKernels& kernels, const CostRow& costs) {
          kernels.correlateWindows(sums.data(),
                                   static_cast<int>(radius),
                                   {means.data(), norms.data()},
                                   {target_means.data(), target_norms.data()},
                                   1000,
                                   costs);
        });
  });
}

/** The paths of one row, and the results of a variant for the previous row. */
struct Paths {
  std::vector<std::int16_t> costs[3], minimum[3];

  Paths(Draw& draw, std::size_t width, std::size_t stride)
  {
    const std::size_t slot = stride + disparity_block;
    for (std::size_t path = 0; path < 3; ++path) {
      costs[path].assign(disparity_block + (width + 2) * slot, 30000);
      minimum[path] = draw.integers<std::int16_t>(width + 2, 0, 500);
      for (std::size_t x = 0; x < width + 2; ++x) {
        const auto drawn = draw.integers<std::int16_t>(stride, 500, 6000);
        std::copy(drawn.begin(),
                  drawn.end(),
                  costs[path].begin() +
                      static_cast<std::ptrdiff_t>(disparity_block + x * slot));
      }
    }
  }

  PathRows
  rows()
  {
    PathRows rows{};
    for (std::size_t path = 0; path < 3; ++path) {
      rows.costs[path] = costs[path].data() + disparity_block;
      rows.minimum[path] = minimum[path].data();
    }
    return rows;
  }
};

TEST_F(PairKernelVariants, Follow)
{
  forSizes([](Draw& draw, std::size_t width, std::size_t stride, std::size_t) {
    auto costs = draw.integers<std::int16_t>(width * stride, 0, largest_cost);
    const auto sums_before = draw.integers<std::int16_t>(width * stride, 0, 20000);
    std::vector<std::int16_t> large[4];
    for (auto& row : large)
      row = draw.integers<std::int16_t>(width, 300, 2000);
    const PathPenalties penalties{
        100, large[0].data(), {large[1].data(), large[2].data(), large[3].data()}};
    const Paths before(draw, width, stride);
    for (const bool reversed : {false, true}) {
      const auto run = [&](const PairKernels& kernels, Paths& after) {
        auto sums = sums_before;
        Paths from = before;
        kernels.follow(
            {costs.data(), static_cast<int>(width), static_cast<int>(stride)},
            penalties,
            from.rows(),
            after.rows(),
            reversed,
            sums.data());
        return sums;
      };
      Paths plain = before, wide = before;
      ASSERT_EQ(run(pair_kernels_avx2, wide), run(pair_kernels_base, plain));
      for (std::size_t path = 0; path < 3; ++path) {
        ASSERT_EQ(wide.costs[path], plain.costs[path]);
        ASSERT_EQ(wide.minimum[path], plain.minimum[path]);
      }
    }
  });
}

TEST_F(PairKernelVariants, FindWinners)
{
  forSizes([](Draw& draw, std::size_t width, std::size_t stride, std::size_t shots) {
    // few values, so that there are many ties
    auto sums = draw.integers<std::int16_t>(width * stride, -5, 5);
    const int disparities = static_cast<int>(stride - shots);
    const auto run = [&](const PairKernels& kernels) {
      std::vector<std::int16_t> index(width), minimum(width + stride, 32767),
          pixel(width + stride, -1);
      kernels.findWinners(
          {sums.data(), static_cast<int>(width), static_cast<int>(stride)},
          disparities,
          {index.data(), minimum.data(), pixel.data()});
      index.insert(index.end(), minimum.begin(), minimum.end());
      index.insert(index.end(), pixel.begin(), pixel.end());
      return index;
    };
    ASSERT_EQ(run(pair_kernels_avx2), run(pair_kernels_base));
  });
}

/** A row of a pair with random winners, the rows of its sums, and what they are of. */
struct SummedRow {
  std::vector<int> shifts, least, greatest;
  std::vector<float> levels, target, products, sums[4], target_sums[4];
  MatchedRow row{};
  int width, shots;
  static constexpr int beside = 4; ///< px of the neighbour's row that are summed

  SummedRow(const PairKernels& kernels, Draw& draw, int width, int shots, int spread)
  : shifts(static_cast<std::size_t>(width + 4), MatchedRow::outside)
  , levels(draw.floats(static_cast<std::size_t>(whole(width) * shots)))
  , target(draw.floats(static_cast<std::size_t>(stride(width) * shots)))
  , width(width)
  , shots(shots)
  {
    const auto drawn =
        draw.integers<int>(static_cast<std::size_t>(width), 0, spread + 0.999);
    for (int x = 0; x < width; ++x)
      if (x + drawn[static_cast<std::size_t>(x)] < width)
        shifts[static_cast<std::size_t>(x + 2)] = drawn[static_cast<std::size_t>(x)];
    for (int x = 0; x < width; ++x) {
      const auto five = shifts.begin() + x;
      least.push_back(*std::min_element(five, five + 5));
      greatest.push_back(*std::max_element(five, five + 5));
    }
    row.shifts = shifts.data() + 2;
    row.least = least.data();
    row.greatest = greatest.data();
    sum(kernels);
  }

  static int
  whole(int count)
  {
    return (count + 7) / 8 * 8;
  }

  static int
  stride(int width)
  {
    return whole(width + 2 * beside) + 16;
  }

  float
  level(int x, int k) const
  {
    return levels[static_cast<std::size_t>(k * whole(width) + x)];
  }

  /** The neighbour's level at a quarter pixel, in double precision. */
  double
  targetLevel(int quarters, int k) const
  {
    const int pixel = (quarters + 4 * beside) / 4 - beside;
    double value = 0;
    for (int tap = 0; tap < 4; ++tap)
      value += static_cast<double>(cubic_weights[static_cast<std::size_t>(
                   tap)][static_cast<std::size_t>(quarters - 4 * pixel)]) *
               static_cast<double>(target[static_cast<std::size_t>(
                   k * stride(width) + pixel + tap - 1 + beside)]);
    return value;
  }

private:
  static LevelSums
  resized(std::vector<float> (&all)[4], int count, int before)
  {
    for (auto& one : all)
      one.assign(static_cast<std::size_t>(count + 2 * before), 0.0F);
    return {&all[0][static_cast<std::size_t>(before)],
            &all[1][static_cast<std::size_t>(before)],
            &all[2][static_cast<std::size_t>(before)],
            &all[3][static_cast<std::size_t>(before)]};
  }

  static LevelSums
  movedBy(const LevelSums& at, int first)
  {
    return {at.squares + first,
            at.values + first,
            at.squares_of_five + first,
            at.values_of_five + first};
  }

  void
  sum(const PairKernels& kernels)
  {
    const ShotRows<float> from{levels.data(), whole(width), shots};
    const ShotRows<float> to{target.data() + beside, stride(width), shots};
    products.assign(static_cast<std::size_t>(8 * (width + 4)), 0.0F);
    products_of_five.assign(products.size(), 0.0F);
    kernels.sumProducts(from, to, width, row.shifts, products.data() + 16);
    kernels.sumFive(products.data() + 16, 8 * width, 8, products_of_five.data() + 16);
    row.products = products.data() + 16;
    row.products_of_five = products_of_five.data() + 16;
    const auto sumFive = [&](const LevelSums& of, int count, int step) {
      kernels.sumFive(of.squares, count, step, of.squares_of_five);
      kernels.sumFive(of.values, count, step, of.values_of_five);
    };
    row.reference = resized(sums, whole(width), 8);
    kernels.sumLevels(from, whole(width), true, row.reference);
    sumFive(row.reference, whole(width), 1);
    const int columns = whole(width + 2 * beside);
    row.target = resized(target_sums, 4 * columns, 24);
    kernels.sumQuarters(
        {to.values - 3, to.plane, shots}, columns, true, movedBy(row.target, -12));
    sumFive(movedBy(row.target, -4), 4 * columns, 4);
  }

  std::vector<float> products_of_five;
};

/** Correlates three rows of random levels. */
std::vector<WindowMatch>
correlated(const PairKernels& kernels, const SummedRow (&rows)[3], bool centred)
{
  const MatchedRow* const all[] = {&rows[0].row, &rows[1].row, &rows[2].row};
  std::vector<WindowMatch> matches(static_cast<std::size_t>(rows[1].width));
  kernels.correlateAround(all,
                          3,
                          rows[1].row,
                          {rows[1].width, rows[1].shots, 0.01F, centred},
                          matches.data());
  return matches;
}

/** Three rows; a spread of 0 makes all windows complete. */
template <typename Check>
void
forWindows(const Check& check)
{
  for (const int width : {1, 2, 5, 8, 9, 31, 40})
    for (const int shots : {1, 2, 7})
      for (const int spread : {0, 1, 2, 6})
        for (const bool centred : {false, true})
          check(width, shots, spread, centred);
}

TEST_F(PairKernelVariants, CorrelateAround)
{
  forWindows([](int width, int shots, int spread, bool centred) {
    const auto run = [&](const PairKernels& kernels) {
      Draw draw(false);
      const SummedRow rows[] = {{kernels, draw, width, shots, spread},
                                {kernels, draw, width, shots, spread},
                                {kernels, draw, width, shots, spread}};
      std::vector<float> all;
      for (const WindowMatch& match : correlated(kernels, rows, centred)) {
        all.insert(all.end(), match.correlation, match.correlation + 8);
        all.insert(all.end(), {match.variance, match.size});
      }
      return all;
    };
    ASSERT_TRUE(areSame(run(pair_kernels_avx2), run(pair_kernels_base)));
  });
}

/** The ZNCC of a window by its definition. */
double
correlationOf(const SummedRow (&rows)[3], int x, int place, bool centred)
{
  const int shift = rows[1].row.shifts[x];
  std::vector<double> left, right;
  for (const SummedRow& row : rows)
    for (int i = std::max(x - 2, 0); i <= std::min(x + 2, row.width - 1); ++i)
      if (std::abs(row.row.shifts[i] - shift) <= 1)
        for (int k = 0; k < row.shots; ++k) {
          left.push_back(static_cast<double>(row.level(i, k)));
          right.push_back(row.targetLevel(4 * (i + shift) + place - 4, k));
        }
  const auto size = static_cast<double>(left.size());
  const auto meanOf = [&](const std::vector<double>& all) {
    return centred ? 0.0 : std::accumulate(all.begin(), all.end(), 0.0) / size;
  };
  const double left_mean = meanOf(left), right_mean = meanOf(right);
  double product = 0, left_square = 0.01 * size, right_square = 0.01 * size;
  for (std::size_t i = 0; i < left.size(); ++i) {
    product += (left[i] - left_mean) * (right[i] - right_mean);
    left_square += (left[i] - left_mean) * (left[i] - left_mean);
    right_square += (right[i] - right_mean) * (right[i] - right_mean);
  }
  return product / std::sqrt(left_square * right_square);
}

TEST_F(PairKernelVariants, WindowsAreCorrelatedByDefinition)
{
  forWindows([](int width, int shots, int spread, bool centred) {
    Draw draw(false);
    const PairKernels& kernels = pair_kernels_avx2;
    const SummedRow rows[] = {{kernels, draw, width, shots, spread},
                              {kernels, draw, width, shots, spread},
                              {kernels, draw, width, shots, spread}};
    const auto matches = correlated(kernels, rows, centred);
    for (int x = 0; x < width; ++x)
      for (int place = 0; rows[1].row.shifts[x] != MatchedRow::outside && place < 8;
           ++place) {
        const WindowMatch& match = matches[static_cast<std::size_t>(x)];
        ASSERT_NEAR(static_cast<double>(match.correlation[place]),
                    correlationOf(rows, x, place, centred),
                    1e-4)
            << x << " of " << width << ", " << shots << " shots, place " << place;
      }
  });
}

#endif

} // namespace
} // namespace pcl::acmap::test
