#include "fusion/shot_coverage.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr int width = 37;
constexpr int height = 23;

/** Gaussian noise on grey; equal values in all channels. */
CameraImage
noisy(std::uint64_t seed, double grey, double deviation, int channels = 1)
{
  Random random(seed);
  CameraImage image{width, height, channels, {}};
  for (int i = 0; i < width * height; ++i) {
    const double value = std::clamp(grey + deviation * random.normal(), 0.0, 255.0);
    image.values.insert(image.values.end(),
                        static_cast<std::size_t>(channels),
                        static_cast<std::uint8_t>(std::lround(value)));
  }
  return image;
}

/** Smoothed with the same weights, in double precision. */
double
plainLevel(const CameraImage& image, int column, int row)
{
  double sum = 0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      const int from_row = std::clamp(row + y, 0, height - 1);
      const int from_column = std::clamp(column + x, 0, width - 1);
      const auto pixel = static_cast<std::size_t>(from_row * width + from_column);
      sum += (2 - std::abs(x)) * (2 - std::abs(y)) *
             image.values[pixel * static_cast<std::size_t>(image.channels)];
    }
  return sum / 16;
}

double
plainShare(const std::vector<CameraImage>& shots, double deviation)
{
  int told_apart = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      double sum = 0, squares = 0;
      for (const CameraImage& shot : shots) {
        const double level = plainLevel(shot, column, row);
        sum += level / static_cast<double>(shots.size());
        squares += level * level / static_cast<double>(shots.size());
      }
      told_apart += squares - sum * sum >= deviation * deviation ? 1 : 0;
    }
  return told_apart / static_cast<double>(width * height);
}

TEST(ShotCoverage, IsTheShareOfPixelsThatChangeEnough)
{
  for (const int channels : {1, 3}) {
    ShotCoverage coverage(width, height);
    std::vector<CameraImage> shots;
    for (std::uint64_t seed = 1; seed < 9; ++seed) {
      shots.push_back(noisy(seed, 100, 20, channels));
      coverage.add(shots.back());
      for (const double deviation : {3.0, 6.5, 9.0})
        EXPECT_NEAR(coverage.share(deviation), plainShare(shots, deviation), 1e-9);
    }
  }
}

TEST(ShotCoverage, OfOneShotIsWhatDiffersFromTheDark)
{
  ShotCoverage coverage(width, height);
  EXPECT_EQ(coverage.share(2), 0);
  const CameraImage dark = noisy(1, 60, 0), lit = noisy(2, 80, 20);
  ShotCoverage alone(width, height);
  alone.add(lit);
  EXPECT_EQ(alone.share(2), 0);
  coverage.setDark(dark);
  EXPECT_EQ(coverage.share(2), 0);
  coverage.add(lit);
  EXPECT_NEAR(coverage.share(6), plainShare({dark, lit}, 6), 1e-9);
  coverage.add(lit); // equal lit shots have no variance, independent of the dark shot
  EXPECT_EQ(coverage.share(2), 0);
}

TEST(ShotCoverage, NoiseIsNoCoverage)
{
  ShotCoverage coverage(width, height);
  for (std::uint64_t seed = 1; seed < 11; ++seed)
    coverage.add(noisy(seed, 100, 3));
  EXPECT_LT(coverage.share(2), 0.01);
}

TEST(ShotCoverage, BrightestAndMostShotsDoNotOverflow)
{
  ShotCoverage coverage(width, height);
  for (std::size_t i = 0; i < ShotCoverage::max_shots; ++i)
    coverage.add(noisy(1, i == 0 ? 0 : 255, 0));
  EXPECT_EQ(coverage.share(15.87), 1); // 255 * sqrt (256) / 257
  EXPECT_EQ(coverage.share(15.88), 0);
}

} // namespace
} // namespace pcl::acmap::test
