#include "simd/pair_kernels.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <vector>

namespace pcl::acmap::test {
namespace {

#ifdef ACMAP_SIMD_AVX2

/** Random inputs, including values that variants of a kernel could treat
 * differently. */
class Draw {
public:
  explicit Draw(bool has_edges)
  : has_edges_(has_edges)
  {}

  std::vector<float>
  floats(std::size_t size)
  {
    constexpr float maximum = std::numeric_limits<float>::max();
    static const float edges[] = {0.0F,
                                  -0.0F,
                                  std::numeric_limits<float>::denorm_min(),
                                  -3e-39F,
                                  maximum,
                                  -maximum,
                                  std::numeric_limits<float>::infinity(),
                                  std::numeric_limits<float>::quiet_NaN()};
    std::vector<float> all(size);
    for (float& one : all)
      one = has_edges_ && random_.bits() % 16 == 0
                ? edges[random_.bits() % std::size(edges)]
                : static_cast<float>(random_.uniform(-1, 1));
    return all;
  }

  template <typename Integer>
  std::vector<Integer>
  integers(std::size_t size, double minimum, double maximum)
  {
    std::vector<Integer> all(size);
    for (Integer& one : all)
      one = static_cast<Integer>(random_.uniform(minimum, maximum));
    return all;
  }

  std::vector<std::uint64_t>
  words(std::size_t size)
  {
    std::vector<std::uint64_t> all(size);
    for (std::uint64_t& one : all)
      one = random_.bits() % 16 == 0 ? ~std::uint64_t{0} : random_.bits();
    return all;
  }

private:
  Random random_{9};
  bool has_edges_;
};

/** Compares with any NaN, as the standard does not define which NaN a sum returns. */
bool
areSame(const std::vector<float>& a, const std::vector<float>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::memcmp(&a[i], &b[i], sizeof a[i]) != 0 &&
        !(std::isnan(a[i]) && std::isnan(b[i])))
      return false;
  return a.size() == b.size();
}

/** Widths that are not multiples of the vector size, strides of one and several
 * blocks. */
class PairKernelVariants : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!__builtin_cpu_supports("avx2"))
      GTEST_SKIP() << "this processor has no AVX2";
  }

  /** \param[in] check function of (width, stride, shots), and the source of random
   * inputs */
  template <typename Check>
  static void
  forSizes(const Check& check)
  {
    for (const bool has_edges : {false, true})
      for (std::size_t width = 0; width <= 40; ++width)
        for (const std::size_t stride : {16U, 48U, 80U})
          for (const std::size_t shots : {0U, 1U, 7U}) {
            Draw draw(has_edges);
            check(draw, width, stride, shots);
          }
  }

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

template <typename Value>
ShotRows<Value>
rowsOf(const std::vector<Value>& values, std::size_t plane, std::size_t shots)
{
  return {values.data(), static_cast<std::int64_t>(plane), static_cast<int>(shots)};
}

TEST_F(PairKernelVariants, Correlate)
{
  forSizes([](Draw& draw, std::size_t width, std::size_t stride, std::size_t shots) {
    const auto reference = draw.floats(width * shots);
    const auto target = draw.floats((width + stride) * shots);
    expectSameCosts(
        width, stride, [&](const PairKernels& kernels, const CostRow& costs) {
          kernels.correlate(rowsOf(reference, width, shots),
                            rowsOf(target, width + stride, shots),
                            1000,
                            costs);
        });
  });
}

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

TEST_F(PairKernelVariants, SumAtQuarters)
{
  for (const bool has_edges : {false, true})
    for (std::size_t shots = 0; shots <= 40; ++shots) {
      Draw draw(has_edges);
      const auto pixel = draw.floats(shots), target = draw.floats(16 * shots);
      const auto run = [&](const PairKernels& kernels) {
        SubPixelSums sums{};
        kernels.sumAtQuarters(rowsOf(pixel, 1, shots), rowsOf(target, 16, shots), sums);
        std::vector<float> all(sums.products, sums.products + 16);
        all.insert(all.end(), sums.squares, sums.squares + 16);
        all.insert(all.end(), sums.values, sums.values + 16);
        return all;
      };
      ASSERT_TRUE(areSame(run(pair_kernels_avx2), run(pair_kernels_base))) << shots;
    }
}

TEST_F(PairKernelVariants, SumWindow)
{
  constexpr std::size_t of_pixel = 3 * SubPixelSums::quarters;
  for (const bool has_edges : {false, true})
    for (std::size_t count = 0; count <= 40; ++count)
      for (const bool wants_values : {false, true}) {
        Draw draw(has_edges);
        const auto sums = draw.floats(of_pixel * (count + 1));
        std::vector<const float*> pixels;
        for (std::size_t i = 0; i < count; ++i)
          pixels.push_back(&sums[of_pixel * i + i % 8]);
        const auto run = [&](const PairKernels& kernels) {
          WindowAtQuarters window{};
          kernels.sumWindow(
              pixels.data(), static_cast<int>(count), wants_values, window);
          std::vector<float> all(window.products, window.products + 8);
          all.insert(all.end(), window.squares, window.squares + 8);
          all.insert(all.end(), window.values, window.values + 8);
          return all;
        };
        ASSERT_TRUE(areSame(run(pair_kernels_avx2), run(pair_kernels_base))) << count;
      }
}

#endif

} // namespace
} // namespace pcl::acmap::test
