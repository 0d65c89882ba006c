#include "pattern/side_lobes.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

std::vector<int>
stripes(int size, int period)
{
  std::vector<int> values;
  for (int i = 0; i < size; ++i)
    values.push_back(i % period < period / 2 ? 700 : 0);
  return values;
}

/** \brief Independent runs of a few pixels, similar to a row of a line pattern. */
std::vector<int>
randomRuns(std::size_t size, std::uint64_t seed)
{
  Random random(seed);
  std::vector<int> values;
  while (values.size() < size)
    values.insert(values.end(),
                  static_cast<std::size_t>(random.uniform(2, 7)),
                  static_cast<int>(random.uniform(0, 766)));
  values.resize(size);
  return values;
}

/** \brief Straightforward implementation of the definition. */
double
correlationOf(const std::vector<int>& values, std::size_t shift)
{
  const std::size_t size = values.size() - shift;
  double mean_a = 0;
  double mean_b = 0;
  for (std::size_t i = 0; i < size; ++i) {
    mean_a += values[i] / static_cast<double>(size);
    mean_b += values[i + shift] / static_cast<double>(size);
  }
  double ab = 0;
  double aa = 0;
  double bb = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const double a = values[i] - mean_a;
    const double b = values[i + shift] - mean_b;
    ab += a * b;
    aa += a * a;
    bb += b * b;
  }
  return ab / std::sqrt(aa * bb);
}

TEST(PatternSideLobes, AreWhatThePlainDefinitionGives)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<int> values = randomRuns(3000, seed);
    std::size_t shift = 1;
    while (correlationOf(values, shift) >= 0.5)
      ++shift;
    while (correlationOf(values, shift + 1) <= correlationOf(values, shift))
      ++shift;
    double highest = 0;
    while (++shift <= 64)
      highest = std::max(highest, correlationOf(values, shift));
    EXPECT_NEAR(sideLobeOf(values, 64), highest, 1e-9);
    EXPECT_LT(highest, 0.3);
  }
}

TEST(PatternSideLobes, StripesAreFoundWithinTheRangeOnly)
{
  EXPECT_NEAR(sideLobeOf(stripes(1024, 40), 64), 1.0, 1e-9);
  EXPECT_NEAR(sideLobeOf(stripes(1024, 40), 40), 1.0, 1e-9);
  EXPECT_LT(sideLobeOf(stripes(1024, 40), 30), 0.5);
}

TEST(PatternSideLobes, RowsWithoutContrastOrEndOfTheMainLobeAreTheWorst)
{
  EXPECT_EQ(sideLobeOf(std::vector<int>(100, 300), 20), 1.0);
  EXPECT_EQ(sideLobeOf(std::vector<int>(100, 0), 20), 1.0);
  std::vector<int> slope(1000);
  for (int i = 0; i < 1000; ++i)
    slope[static_cast<std::size_t>(i)] = i / 2;
  EXPECT_EQ(sideLobeOf(slope, 64), 1.0);
  EXPECT_EQ(sideLobeOf({5}, 64), 1.0);
  EXPECT_EQ(sideLobeOf({5, 9}, 64), 1.0);
}

TEST(PatternSideLobes, RegularStripesFailTheGateAndRandomRowsPass)
{
  RgbImage upright{512, 300, std::vector<std::uint8_t>(3 * 512 * 300)};
  RgbImage random = upright;
  const std::vector<int> stripe = stripes(512, 32);
  for (int row = 0; row < 300; ++row) {
    const std::vector<int> runs = randomRuns(512, static_cast<std::uint64_t>(row));
    for (int column = 0; column < 512; ++column)
      for (int channel = 0; channel < 3; ++channel) {
        const auto at = static_cast<std::size_t>(column);
        upright.at(column, row)[channel] = static_cast<std::uint8_t>(stripe[at] / 3);
        random.at(column, row)[channel] = static_cast<std::uint8_t>(runs[at] / 3);
      }
  }
  EXPECT_GT(rowSideLobes(upright, 64).gated, 0.99);
  EXPECT_GE(columnSideLobes(upright, 64).gated, highest_side_lobe); // no contrast
  EXPECT_LT(rowSideLobes(random, 64).gated, highest_side_lobe);
}

TEST(PatternSideLobes, OneBadRowInAHundredIsForgivenAndTold)
{
  RgbImage image{512, 200, std::vector<std::uint8_t>(3 * 512 * 200)};
  for (int row = 0; row < 200; ++row) {
    const std::vector<int> runs = randomRuns(512, static_cast<std::uint64_t>(row));
    for (int column = 0; column < 512; ++column)
      std::fill_n(
          image.at(column, row),
          3,
          static_cast<std::uint8_t>(runs[static_cast<std::size_t>(column)] / 3));
  }
  const auto darken = [&](int row) { std::fill_n(image.at(0, row), 3 * 512, 0); };
  darken(50);
  EXPECT_LT(rowSideLobes(image, 64).gated, highest_side_lobe);
  EXPECT_EQ(rowSideLobes(image, 64).worst, 1.0);
  for (const int row : {60, 70})
    darken(row);
  EXPECT_EQ(rowSideLobes(image, 64).gated, 1.0);
}

} // namespace
} // namespace pcl::acmap::test
