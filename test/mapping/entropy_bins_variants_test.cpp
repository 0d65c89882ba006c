#include "entropy_bins_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::acmap::test {
namespace {

/** Results of a variant, which must be the same for all. */
struct Bytes {
  std::vector<double> values;

  explicit Bytes(const EntropyBins& loops)
  {
    BinsScene scene(5, 400);
    loops.fill(scene.cells(), motion, scene.grid());
    loops.fillDirected(scene.cells(), motion, scene.grid());
    keep(scene.bins);
    values.insert(values.end(), scene.marks.begin(), scene.marks.end());
    for (const auto& forces :
         {loops.forces(scene.cells(), motion, scene.grid()),
          loops.forcesDirected(scene.cells(), motion, scene.grid())})
      keep<double>({forces.x, forces.z, forces.turn, forces.layers});
    std::vector<double> sums(400, 0.1);
    keep<double>({loops.sumUp(scene.bins.data(), 400, sums.data())});
    keep(sums);
    for (const std::int64_t radius : {1, 3, 5, 13})
      smooth(loops, scene, radius);
    keep<double>({loops.takeExactLogarithms(sums.data(), 400)});
    keep(sums);
  }

  template <typename Number>
  void
  keep(const std::vector<Number>& more)
  {
    values.insert(values.end(), more.begin(), more.end());
  }

  void
  smooth(const EntropyBins& loops, const BinsScene& scene, std::int64_t radius)
  {
    std::vector<float> weights, across(80, 0), out(40, 7);
    const std::vector<float> levels(40, 0.3F);
    for (std::int64_t i = 0; i <= radius; ++i)
      weights.push_back(1 / static_cast<float>(3 + i));
    const SmoothingKernel kernel{weights.data(), radius};
    for (const std::int64_t size : {40, 12, 8, 4}) {
      loops.smoothAcross(&scene.bins[20 * 40], 40, kernel, size, &across[20]);
      keep(across);
      keep<double>({loops.takeLogarithms(&across[20], kernel, size, out.data())});
      keep(out);
      loops.takeFromLevels(
          &across[20], kernel, {0.7F, levels.data()}, size, out.data());
      keep(out);
    }
  }
};

TEST(EntropyBins, allVariantsGiveTheSameBytes)
{
  const Bytes wanted(entropy_bins_base);
  for (const BinsVariant& variant : variants()) {
    const Bytes found(*variant.loops);
    ASSERT_EQ(found.values.size(), wanted.values.size());
    EXPECT_EQ(std::memcmp(found.values.data(),
                          wanted.values.data(),
                          wanted.values.size() * sizeof(double)),
              0)
        << variant.name;
  }
}

/** Invalid bins, which contain denormals, NaN and others. */
std::vector<float>
edgeBins(std::size_t size)
{
  constexpr float maximum = std::numeric_limits<float>::max();
  const std::vector<float> edges{0,
                                 -0.0F,
                                 std::numeric_limits<float>::denorm_min(),
                                 1e-39F,
                                 maximum,
                                 std::numeric_limits<float>::infinity(),
                                 std::numeric_limits<float>::quiet_NaN(),
                                 -1};
  Random random(6);
  std::vector<float> bins(size);
  for (float& bin : bins)
    bin = random.bits() % 8 == 0 ? edges[random.bits() % edges.size()]
                                 : static_cast<float>(random.uniform(0, 3));
  return bins;
}

/** Appends numbers; replaces NaN, as the standard does not define the NaN of a sum. */
template <typename Number>
void
keepBits(const std::vector<Number>& numbers, std::vector<double>& all)
{
  for (const Number number : numbers)
    all.push_back(std::isnan(number) ? 1e300 : static_cast<double>(number));
}

std::vector<double>
edgeValues(const EntropyBins& loops, std::int64_t size, std::int64_t radius)
{
  const auto length = static_cast<std::size_t>(size);
  std::vector<double> all;
  const std::vector<float> bins = edgeBins(27 * 80), levels = edgeBins(length),
                           weights(static_cast<std::size_t>(radius + 1), 0.3F);
  const float* const middle = &bins[13 * 80 + 20];
  const SmoothingKernel kernel{weights.data(), radius};
  std::vector<float> out(length);
  loops.smoothAcross(middle, 80, kernel, size, out.data());
  keepBits(out, all);
  keepBits<double>({loops.takeLogarithms(middle, kernel, size, out.data())}, all);
  keepBits(out, all);
  loops.takeFromLevels(middle, kernel, {0.5F, levels.data()}, size, out.data());
  keepBits(out, all);
  std::vector<double> sums(bins.begin(), bins.begin() + size);
  keepBits<double>({loops.sumUp(middle, size, sums.data())}, all);
  keepBits<double>({loops.takeExactLogarithms(sums.data(), size)}, all);
  keepBits(sums, all);
  return all;
}

TEST(EntropyBins, allVariantsGiveTheSameBytesOfEdgesAndSizes)
{
  for (std::int64_t size = 0; size <= 40; size += 4)
    for (const std::int64_t radius : {0, 1, 3, 13}) {
      const auto wanted = edgeValues(entropy_bins_base, size, radius);
      for (const BinsVariant& variant : variants()) {
        const auto found = edgeValues(*variant.loops, size, radius);
        ASSERT_EQ(
            std::memcmp(found.data(), wanted.data(), wanted.size() * sizeof(double)), 0)
            << variant.name << ", size " << size << ", radius " << radius;
      }
    }
}

TEST(EntropyBins, allVariantsGiveTheSameBytesOfAnyNumberOfCells)
{
  for (std::size_t cells = 4; cells <= 40; cells += 4) {
    const auto valuesOf = [&](const EntropyBins& loops) {
      BinsScene scene(cells, cells);
      scene.weight[1] = 1e-39F;
      scene.weight[2] = 0;
      scene.x[3] = std::numeric_limits<float>::denorm_min();
      loops.fill(scene.cells(), motion, scene.grid());
      loops.fillDirected(scene.cells(), motion, scene.grid());
      const CellForces forces = loops.forces(scene.cells(), motion, scene.grid());
      const CellForces turned =
          loops.forcesDirected(scene.cells(), motion, scene.grid());
      std::vector<double> all(scene.bins.begin(), scene.bins.end());
      for (const CellForces& one : {forces, turned})
        all.insert(all.end(), {one.x, one.z, one.turn, one.layers});
      return all;
    };
    const auto wanted = valuesOf(entropy_bins_base);
    for (const BinsVariant& variant : variants()) {
      const auto found = valuesOf(*variant.loops);
      EXPECT_EQ(
          std::memcmp(found.data(), wanted.data(), wanted.size() * sizeof(double)), 0)
          << variant.name << ", " << cells << " cells";
    }
  }
}

} // namespace
} // namespace pcl::acmap::test
