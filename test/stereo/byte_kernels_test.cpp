#include "kernel_variants.h"

#include "simd/byte_kernels.h"
#include "simd/image_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap::test {
namespace {

#ifdef ACMAP_SIMD_AVX2

using Bytes = std::vector<std::uint8_t>;

class ByteKernelVariants : public KernelVariants {
protected:
  /** As forSizes, with strides of whole byte blocks. */
  template <typename Check>
  static void
  forStrides(const Check& check)
  {
    for (const std::size_t width : {0U, 1U, 7U, 8U, 33U})
      for (const std::size_t stride : {32U, 64U, 96U})
        for (const std::size_t shots : {1U, 5U, 10U}) {
          Draw draw(false);
          check(draw, width, stride, shots);
        }
  }
};

TEST_F(ByteKernelVariants, EncodeNormalizesLevels)
{
  forStrides([](Draw& draw, std::size_t width, std::size_t, std::size_t shots) {
    const std::size_t plane = (width + 7) / 8 * 8;
    const auto levels = draw.integers<std::int16_t>(plane * shots, -4080, 4080);
    const auto run = [&](const ByteKernels& kernels) {
      std::vector<std::int32_t> codes(plane * ((shots + 1) / 2));
      kernels.encode(rowsOf(levels, plane, shots),
                     static_cast<int>(width),
                     100,
                     static_cast<std::int64_t>(plane),
                     codes.data());
      return codes;
    };
    const auto codes = run(byte_kernels_avx2);
    ASSERT_EQ(codes, run(byte_kernels_base));
    for (std::size_t x = 0; x < width; ++x) {
      double squares = 100;
      for (std::size_t k = 0; k < shots; ++k)
        squares += std::pow(levels[k * plane + x], 2);
      for (std::size_t k = 0; k < shots; ++k) {
        const std::int32_t pair = codes[k / 2 * plane + x];
        const int code =
            k % 2 == 0 ? static_cast<std::int16_t>(pair & 0xffff) : pair >> 16;
        ASSERT_NEAR(code, 17962.14 * levels[k * plane + x] / std::sqrt(squares), 0.6);
      }
    }
  });
}

TEST_F(ByteKernelVariants, CostsAreThoseOfTheCorrelation)
{
  forStrides([](Draw& draw, std::size_t width, std::size_t stride, std::size_t shots) {
    const std::size_t pairs = (shots + 1) / 2, target_width = width + stride;
    const auto code = [&](std::size_t count) {
      const double most = 17962.0 / std::sqrt(static_cast<double>(2 * pairs));
      auto codes = draw.integers<std::int32_t>(count, -most, most);
      for (std::int32_t& one : codes)
        one =
            (one & 0xffff) | draw.integers<std::int32_t>(1, -most, most)[0] * (1 << 16);
      return codes;
    };
    const auto reference = code(width * pairs), target = code(target_width * pairs);
    const auto run = [&](const ByteKernels& kernels) {
      Bytes costs(width * stride + 1, 77);
      kernels.correlate(
          rowsOf(reference, width, pairs),
          rowsOf(target, target_width, pairs),
          {costs.data(), static_cast<int>(width), static_cast<int>(stride)});
      EXPECT_EQ(costs.back(), 77) << "written beyond the row";
      return costs;
    };
    const Bytes costs = run(byte_kernels_avx2);
    ASSERT_EQ(costs, run(byte_kernels_base));
    const auto half = [](std::int32_t pair, bool high) {
      return high ? pair >> 16 : static_cast<std::int16_t>(pair & 0xffff);
    };
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t i = 0; i < stride; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < pairs; ++k)
          for (const bool high : {false, true})
            sum += static_cast<double>(half(reference[k * width + x], high)) *
                   half(target[k * target_width + x + i], high);
        const double cost = 2000.0 / byte_cost_unit - sum / (1 << 21);
        ASSERT_NEAR(costs[x * stride + i], std::clamp(cost, 0.0, 200.0), 0.51);
      }
  });
}

/** Path costs of the previous row, in slots as the kernel needs them. */
struct BytePaths {
  Bytes costs[3], minimum[3];

  BytePaths(Draw& draw, std::size_t width, std::size_t stride)
  {
    const std::size_t slot = stride + byte_block;
    for (std::size_t path = 0; path < 3; ++path) {
      costs[path].assign(byte_block + (width + 2) * slot, never_byte_cost);
      minimum[path].resize(width + 2);
      for (std::size_t x = 0; x < width + 2; ++x) {
        const auto drawn = draw.integers<std::uint8_t>(stride, 3, 225);
        const auto to =
            costs[path].begin() + static_cast<std::ptrdiff_t>(byte_block + x * slot);
        std::copy(drawn.begin(), drawn.end(), to);
        minimum[path][x] = std::min<std::uint8_t>(
            largest_byte_cost, *std::min_element(drawn.begin(), drawn.end()));
      }
    }
  }

  BytePathRows
  rows()
  {
    BytePathRows rows{};
    for (std::size_t path = 0; path < 3; ++path) {
      rows.costs[path] = costs[path].data() + byte_block;
      rows.minimum[path] = minimum[path].data();
    }
    return rows;
  }
};

/** Equation 13 of Hirschmueller (2008) without the cost itself. */
int
excessByDefinition(const std::uint8_t* before,
                   std::size_t stride,
                   std::size_t i,
                   int minimum,
                   const BytePenalties& penalties)
{
  int least = std::min<int>(before[i], minimum + penalties.large);
  if (i > 0)
    least = std::min(least, before[i - 1] + penalties.small);
  if (i + 1 < stride)
    least = std::min(least, before[i + 1] + penalties.small);
  return least - minimum;
}

TEST_F(ByteKernelVariants, PathsFollowTheirDefinition)
{
  constexpr BytePenalties penalties{8, 31};
  forStrides([&](Draw& draw, std::size_t width, std::size_t stride, std::size_t) {
    auto costs =
        draw.integers<std::uint8_t>(width * stride, 0, largest_byte_cost + 0.9);
    const auto excess_before = draw.integers<std::uint8_t>(width * stride, 0, 100);
    BytePaths before(draw, width, stride);
    for (const bool reversed : {false, true}) {
      const auto run = [&](const ByteKernels& kernels, BytePaths& after) {
        auto excess = excess_before;
        kernels.follow(
            {costs.data(), static_cast<int>(width), static_cast<int>(stride)},
            penalties,
            before.rows(),
            after.rows(),
            reversed,
            excess.data());
        return excess;
      };
      BytePaths plain = before, wide = before;
      const Bytes excess = run(byte_kernels_avx2, wide);
      ASSERT_EQ(excess, run(byte_kernels_base, plain));
      for (std::size_t path = 0; path < 3; ++path) {
        ASSERT_EQ(wide.costs[path], plain.costs[path]);
        ASSERT_EQ(wide.minimum[path], plain.minimum[path]);
      }

      Bytes row(stride, 0);
      int row_minimum = 0;
      for (std::size_t n = 0; n < width; ++n) {
        const std::size_t x = reversed ? width - 1 - n : n;
        Bytes next(stride);
        for (std::size_t i = 0; i < stride; ++i) {
          const int along =
              excessByDefinition(row.data(), stride, i, row_minimum, penalties);
          next[i] = static_cast<std::uint8_t>(costs[x * stride + i] + along);
          int sum = along + (reversed ? excess_before[x * stride + i] : 0);
          for (std::size_t path = 0; path < 3; ++path) {
            const std::size_t from = reversed ? x + 2 - path : x + path;
            sum += excessByDefinition(before.rows().costs[path] +
                                          from * (stride + byte_block),
                                      stride,
                                      i,
                                      before.minimum[path][from],
                                      penalties);
          }
          ASSERT_EQ(excess[x * stride + i], sum) << x << ", " << i;
        }
        row = next;
        row_minimum = *std::min_element(row.begin(), row.end());
      }
    }
  });
}

TEST_F(ByteKernelVariants, FindWinners)
{
  forStrides([](Draw& draw, std::size_t width, std::size_t stride, std::size_t shots) {
    // few values, so that there are many ties
    auto costs = draw.integers<std::uint8_t>(width * stride, 0, 3);
    const auto excess = draw.integers<std::uint8_t>(width * stride, 0, 12);
    const std::size_t disparities = stride - shots;
    const auto run = [&](const ByteKernels& kernels) {
      std::vector<std::int16_t> index(width), minimum(width + stride, 32767),
          pixel(width + stride, -1);
      kernels.findWinners(
          {costs.data(), static_cast<int>(width), static_cast<int>(stride)},
          excess.data(),
          static_cast<int>(disparities),
          {index.data(), minimum.data(), pixel.data()});
      return std::array<std::vector<std::int16_t>, 3>{index, minimum, pixel};
    };
    const auto found = run(byte_kernels_avx2);
    ASSERT_EQ(found, run(byte_kernels_base));
    for (std::size_t x = 0; x < width; ++x) {
      std::size_t best = 0;
      const auto sum = [&](std::size_t i) {
        return 8 * costs[x * stride + i] + excess[x * stride + i];
      };
      for (std::size_t i = 1; i < disparities; ++i)
        if (sum(i) < sum(best))
          best = i;
      ASSERT_EQ(found[0][x], static_cast<int>(best));
    }
  });
}

TEST_F(ByteKernelVariants, Grey)
{
  for (std::size_t count = 0; count < 70; ++count) {
    Draw draw(false);
    const auto colors = draw.integers<std::uint8_t>(3 * count, 0, 255.9);
    const auto run = [&](const ImageKernels& kernels) {
      std::vector<std::int16_t> grey(count + 1, 77);
      kernels.toGrey(colors.data(), static_cast<int>(count), grey.data());
      EXPECT_EQ(grey.back(), 77) << "written beyond the row";
      return grey;
    };
    const auto grey = run(image_kernels_avx2);
    ASSERT_EQ(grey, run(image_kernels_base));
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_EQ(
          grey[i],
          (77 * colors[3 * i] + 150 * colors[3 * i + 1] + 29 * colors[3 * i + 2] + 8) /
              16);
  }
}

TEST_F(ByteKernelVariants, Blur)
{
  constexpr float weights[] = {624, 156, 44};
  for (std::size_t width = 1; width < 40; ++width) {
    Draw draw(false);
    const auto levels = draw.integers<std::int16_t>(width + 4, 0, 4080);
    const auto run = [&](const ImageKernels& kernels) {
      const auto count = static_cast<int>(width);
      std::vector<float> from(width + 4), along(width + 1, 77);
      kernels.toFloats(levels.data(), count + 4, from.data());
      kernels.blurAlong(from.data() + 2, count, weights, along.data());
      const float* const rows[] = {&from[0], &from[1], &from[2], &from[3], &from[4]};
      std::vector<std::int16_t> across(width + 1, 77);
      kernels.blurAcross(rows, count, weights, across.data());
      EXPECT_EQ(along.back(), 77) << "written beyond the row";
      EXPECT_EQ(across.back(), 77) << "written beyond the row";
      for (std::size_t x = 0; x < width; ++x)
        EXPECT_EQ(along[x], across[x]) << "rows that are shifted blur to the same";
      return across;
    };
    const auto blurred = run(image_kernels_avx2);
    ASSERT_EQ(blurred, run(image_kernels_base));
    for (std::size_t x = 0; x < width; ++x)
      ASSERT_EQ(blurred[x],
                (624 * levels[x + 2] + 156 * (levels[x + 1] + levels[x + 3]) +
                 44 * (levels[x] + levels[x + 4]) + 512) /
                    1024);
  }
}

#endif

} // namespace
} // namespace pcl::acmap::test
