#include "entropy/filled_runs.h"
#include "entropy_bins_scene.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pcl::acmap::test {
namespace {

double
splineAt(double t)
{
  t = std::abs(t);
  if (t >= 1.5)
    return 0;
  return t > 0.5 ? 0.5 * (1.5 - t) * (1.5 - t) : 0.75 - t * t;
}

/** Weight of bin (i, j) of layer k for a cell, by the definition. */
double
shareOf(const BinsScene& scene, std::size_t cell, int i, int j, int k, bool directed)
{
  const double x = scene.x[cell], z = scene.z[cell];
  const double u = motion.x0 + motion.cosine * x + motion.sine * z;
  const double v = motion.z0 + motion.cosine * z - motion.sine * x;
  const double share = splineAt(u - i - 0.5) * splineAt(v - j - 0.5);
  if (!directed)
    return k == 0 ? share : 0;
  const double angle = static_cast<double>(scene.direction[cell]) + motion.turn;
  return k < 8 ? share * splineAt(std::remainder(angle - k - 0.5, 8)) : 0;
}

TEST(EntropyBins, areFilledBySplines)
{
  for (const BinsVariant& variant : variants())
    for (const bool directed : {false, true}) {
      SCOPED_TRACE(variant.name);
      BinsScene scene(1, 12);
      const auto fill = directed ? variant.loops->fillDirected : variant.loops->fill;
      fill(scene.cells(), motion, scene.grid());
      for (int k = 0; k < 9; ++k)
        for (int i = 0; i < 40; ++i)
          for (int j = 0; j < 40; ++j) {
            double wanted = 0;
            for (std::size_t cell = 0; cell < scene.x.size(); ++cell)
              wanted += static_cast<double>(scene.weight[cell]) *
                        shareOf(scene, cell, i, j, k, directed);
            const std::size_t at = static_cast<std::size_t>((k * 40 + i) * 40 + j);
            ASSERT_NEAR(scene.bins[at], wanted, 1e-4); // for weights up to 100
            bool is_marked = false;
            for (std::size_t up = 0; up < 3 && up * 10 <= at / 4; ++up)
              is_marked |= scene.marks[at / 4 - up * 10] != 0;
            if (scene.bins[at] != 0) {
              ASSERT_TRUE(is_marked) << "three rows belong to a mark";
            }
          }
    }
}

/** Energy of a field: sum over the bins of weight times field value. */
double
energyOf(const BinsScene& scene,
         const BinsVariant& variant,
         CellMotion moved,
         bool directed)
{
  BinsScene filled(scene);
  std::fill(filled.bins.begin(), filled.bins.end(), 0);
  (directed ? variant.loops->fillDirected
            : variant.loops->fill)(filled.cells(), moved, filled.grid());
  double sum = 0;
  for (std::size_t i = 0; i < filled.bins.size(); ++i)
    sum += static_cast<double>(filled.bins[i]) * static_cast<double>(scene.bins[i]);
  return sum;
}

TEST(EntropyBins, forcesAreTheDerivativesOfFilling)
{
  for (const BinsVariant& variant : variants())
    for (const bool directed : {false, true}) {
      SCOPED_TRACE(variant.name);
      BinsScene scene(2, 20);
      Random random(3);
      for (float& bin : scene.bins)
        bin = static_cast<float>(random.uniform(-1, 1));
      const CellForces forces =
          (directed ? variant.loops->forcesDirected
                    : variant.loops->forces)(scene.cells(), motion, scene.grid());
      const auto differenceBy = [&](auto&& change) {
        constexpr double step = 1e-3; // the bins are floats
        CellMotion before = motion, after = motion;
        change(before, -step);
        change(after, step);
        return (energyOf(scene, variant, after, directed) -
                energyOf(scene, variant, before, directed)) /
               (2 * step);
      };
      const double rounding = 1e-2; // for forces of about 100
      EXPECT_NEAR(forces.x,
                  differenceBy([](CellMotion& m, double by) { m.x0 += by; }),
                  rounding);
      EXPECT_NEAR(forces.z,
                  differenceBy([](CellMotion& m, double by) { m.z0 += by; }),
                  rounding);
      EXPECT_NEAR(forces.turn,
                  differenceBy([](CellMotion& m, double by) {
                    const double angle = std::atan2(motion.sine, motion.cosine) + by;
                    m.cosine = std::cos(angle);
                    m.sine = std::sin(angle);
                  }),
                  10 * rounding);
      EXPECT_NEAR(forces.layers,
                  differenceBy([](CellMotion& m, double by) { m.turn += by; }),
                  rounding);
      EXPECT_GT(std::abs(forces.x), 1);
    }
}

/** 0, powers of two, and other numbers; from \a minimum to 1 / least. */
template <typename Number>
std::vector<Number>
numbersFrom(double minimum)
{
  Random random(4);
  std::vector<double> values{
      0, 1, 2, 0.5, std::sqrt(0.5), std::sqrt(2.0), minimum, 1 / minimum};
  for (int i = 0; i < 100000; ++i)
    values.push_back(std::exp(random.uniform(-40, 40)));
  for (int i = 0; i < 1000; ++i)
    values.push_back(1 + random.uniform(-1e-3, 1e-3));
  return {values.begin(), values.end()};
}

/** \param[in] take function (values, size, logarithms) that returns the sum */
template <typename Number, typename Take>
void
expectLogarithms(const std::vector<Number>& values, double rounding, const Take& take)
{
  std::vector<Number> logarithms(values.size());
  const auto size = static_cast<std::int64_t>(values.size());
  const double sum = take(values.data(), size, logarithms.data());
  EXPECT_EQ(logarithms[0], 0) << "nothing where there is nothing";
  EXPECT_EQ(logarithms[1], 0);
  EXPECT_EQ(logarithms[2], 1);
  EXPECT_EQ(logarithms[3], -1);
  double wanted_sum = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const auto value = static_cast<double>(values[i]);
    const double wanted = std::log2(value);
    ASSERT_NEAR(
        static_cast<double>(logarithms[i]), wanted, rounding * (1 + std::abs(wanted)));
    wanted_sum += value * wanted;
  }
  EXPECT_NEAR(sum, wanted_sum, 100 * rounding * std::abs(wanted_sum));
}

TEST(EntropyBins, logarithmsAreExactToRounding)
{
  const auto doubles = numbersFrom<double>(1e-300);
  const auto floats = numbersFrom<float>(0x1p-100);
  const float one = 1;
  for (const BinsVariant& variant : variants()) {
    SCOPED_TRACE(variant.name);
    expectLogarithms(doubles, 1e-14, [&](auto* from, auto size, auto* out) {
      std::copy_n(from, size, out);
      return variant.loops->takeExactLogarithms(out, size);
    });
    expectLogarithms(floats, 1.2e-7, [&](auto* from, auto size, auto* out) {
      return variant.loops->takeLogarithms(from, {&one, 0}, size, out);
    });
  }
}

TEST(EntropyBins, sumsOfMillionsStayExact)
{
  Random random(8);
  std::vector<float> values, logarithms(4000000);
  double wanted = 0;
  for (std::size_t i = 0; i < logarithms.size(); ++i) {
    values.push_back(static_cast<float>(random.uniform(0, 0.3)));
    const auto value = static_cast<double>(values.back());
    wanted += value > 0 ? value * std::log2(value) : 0;
  }
  const float one = 1;
  for (const BinsVariant& variant : variants())
    EXPECT_NEAR(variant.loops->takeLogarithms(
                    values.data(), {&one, 0}, 4000000, logarithms.data()),
                wanted,
                1e-8 * std::abs(wanted));
}

TEST(EntropyBins, smoothingIsConvolution)
{
  BinsScene scene(6, 100);
  entropyBins().fill(scene.cells(), motion, scene.grid());
  constexpr std::int64_t radius = 3, row = 22;
  const std::vector<float> kernel{0.4F, 0.2F, 0.08F, 0.02F};
  const SmoothingKernel by{kernel.data(), radius};
  std::vector<float> across(48, 0), out(40, 0), logarithms(40, 0), levels;
  for (int j = 0; j < 40; ++j)
    levels.push_back(static_cast<float>(j) / 4);
  const EntropyBins& loops = entropyBins();
  loops.smoothAcross(&scene.bins[row * 40], 40, by, 40, &across[4]);
  loops.takeFromLevels(&across[4], by, {0.5F, levels.data()}, 40, out.data());
  loops.takeLogarithms(&across[4], by, 40, logarithms.data());
  double maximum = 0;
  for (std::int64_t j = 0; j < 40; ++j) {
    double wanted = 0;
    for (std::int64_t a = -radius; a <= radius; ++a)
      for (std::int64_t b = -radius; b <= radius; ++b)
        if (j + b >= 0 && j + b < 40)
          wanted += static_cast<double>(
              kernel[static_cast<std::size_t>(std::abs(a))] *
              kernel[static_cast<std::size_t>(std::abs(b))] *
              scene.bins[static_cast<std::size_t>((row + a) * 40 + j + b)]);
    const auto at = static_cast<std::size_t>(j);
    EXPECT_NEAR(static_cast<double>(out[at]),
                0.5 + static_cast<double>(levels[at]) - wanted,
                1e-5 * (1 + wanted));
    EXPECT_NEAR(
        static_cast<double>(logarithms[at]), wanted > 0 ? std::log2(wanted) : 0, 1e-5);
    maximum = std::max(maximum, wanted);
  }
  EXPECT_GT(maximum, 1);
}

TEST(FilledRuns, areAllBlocksNearMarks)
{
  Random random(7);
  for (int round = 0; round < 50; ++round) {
    const double density = round % 2 == 0 ? 0.1 : 0.02;
    BlockMarks blocks;
    blocks.blocks = 1 + static_cast<std::int64_t>(random.uniform(0, 1 + 3 * round));
    blocks.rows = 1 + static_cast<std::int64_t>(random.uniform(0, 9));
    const std::int64_t rows = 3 * blocks.rows;
    for (std::int64_t i = 0; i < rows * blocks.blocks; ++i)
      blocks.marks.push_back(random.uniform() < density);
    const auto before = static_cast<std::int64_t>(random.uniform(0, 3));
    const auto after = static_cast<std::int64_t>(random.uniform(0, 4));
    const auto aside = static_cast<std::int64_t>(random.uniform(0, 3));
    std::vector<int> found(blocks.marks.size(), 0), wanted = found;
    std::int64_t last = -1;
    std::vector<FilledRun> runs(5);
    BlockBits(blocks).findRuns(before, after, aside, runs);
    for (const FilledRun& run : runs) {
      ASSERT_GT(run.row * (blocks.blocks + 1) + run.begin, last) << "in order, apart";
      last = run.row * (blocks.blocks + 1) + run.end;
      for (std::int64_t i = run.begin; i < run.end; ++i)
        ++found[static_cast<std::size_t>(run.row * blocks.blocks + i)];
    }
    for (std::int64_t row = 0; row < rows; ++row)
      for (std::int64_t i = 0; i < blocks.blocks; ++i)
        for (std::int64_t r = 0; r < rows; ++r)
          for (std::int64_t b = 0; b < blocks.blocks; ++b)
            if (blocks.marks[static_cast<std::size_t>(r * blocks.blocks + b)] &&
                r / blocks.rows == row / blocks.rows && row >= r - before &&
                row <= r + after && std::abs(b - i) <= aside)
              wanted[static_cast<std::size_t>(row * blocks.blocks + i)] = 1;
    EXPECT_EQ(found, wanted);
  }
}

} // namespace
} // namespace pcl::acmap::test
