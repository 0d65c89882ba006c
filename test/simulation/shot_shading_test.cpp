#include "light/rig_simulation.h"
#include "lit_scenes.h"
#include "random_streams.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** An unlit view of uniform colour. */
LitView
flatView(int width, int height, float color)
{
  const auto pixels = static_cast<std::size_t>(width * height);
  return {width,
          height,
          std::vector<float>(3 * pixels, color),
          std::vector<float>(pixels),
          std::vector<float>(pixels),
          std::vector<float>(pixels)};
}

TEST(PixelNoise, HasTheMomentsOfANormalDistribution)
{
  constexpr std::size_t size = 2000000;
  std::vector<float> numbers(size);
  fillNormal(7, numbers.data(), size);
  std::array<double, 4> moments{};
  for (const double x : numbers)
    for (std::size_t i = 0; i < moments.size(); ++i)
      moments[i] += std::pow(x, i + 1) / size;
  EXPECT_NEAR(moments[0], 0.0, 0.003);
  EXPECT_NEAR(moments[1], 1.0, 0.004);
  EXPECT_NEAR(moments[2], 0.0, 0.012);
  EXPECT_NEAR(moments[3], 3.0, 0.05);
  double neighbours = 0;
  for (std::size_t i = 1; i < size; ++i)
    neighbours += numbers[i] * numbers[i - 1] / size;
  EXPECT_NEAR(neighbours, 0.0, 0.003);
}

TEST(ShotShading, NoiseIsAsSet)
{
  SimulatedLight light = plainLight();
  light.ambient = 1.0;
  light.read_noise = 2.0;
  light.shot_noise = 0.05;
  for (const float color : {40.3f, 100.0f, 180.7f}) {
    const CameraImage image = shadeShot(flatView(400, 300, color), nullptr, light, 11);
    double sum = 0, squares = 0;
    for (const double value : image.values) {
      sum += value;
      squares += value * value;
    }
    const auto size = static_cast<double>(image.values.size());
    const double mean = sum / size;
    const double rounding = 1.0 / 12.0;
    const double variance = 4.0 + 0.05 * color + rounding;
    EXPECT_NEAR(mean, color, 0.02);
    EXPECT_NEAR(squares / size - mean * mean, variance, 0.01 * variance);
  }
}

TEST(ShotShading, ValuesEndAtBlackAndWhite)
{
  SimulatedLight light = plainLight();
  light.ambient = 1.0;
  light.read_noise = 20.0;
  const CameraImage dark = shadeShot(flatView(64, 48, 0.0f), nullptr, light, 1);
  const auto black = std::count(dark.values.begin(), dark.values.end(), 0);
  EXPECT_NEAR(static_cast<double>(black) / dark.values.size(), 0.51, 0.02);
  const CameraImage bright = shadeShot(flatView(64, 48, 1e6f), nullptr, light, 1);
  EXPECT_EQ(*std::min_element(bright.values.begin(), bright.values.end()), 255);
}

TEST(ShotShading, BlurSpreadsAPointAndKeepsTheRim)
{
  SimulatedLight light = plainLight();
  light.ambient = 1.0;
  light.blur = 0.8;
  LitView view = flatView(21, 21, 0.0f);
  view.color[3 * (10 * 21 + 10) + 1] = 10000.0f / 255.0f * 10.0f;
  const CameraImage image = shadeShot(view, nullptr, light, 1);
  double sum = 0, squares = 0;
  for (int row = 0; row < 21; ++row)
    for (int column = 0; column < 21; ++column) {
      const int value = valueAt(image, column, row, 1);
      sum += value;
      squares += value * (column - 10) * (column - 10);
      EXPECT_EQ(value, valueAt(image, row, column, 1));
      EXPECT_EQ(valueAt(image, column, row, 0), 0);
    }
  EXPECT_NEAR(sum, 392.0, 5.0);
  EXPECT_NEAR(std::sqrt(squares / sum), 0.8, 0.05);
  const CameraImage flat = shadeShot(flatView(5, 1, 77.0f), nullptr, light, 1);
  EXPECT_EQ(flat.values, std::vector<std::uint8_t>(15, 77));
}

TEST(ShotShading, EachCameraShotAndSeedHasItsOwnNoise)
{
  SimulatedLight light = plainLight();
  light.read_noise = 3.0;
  const SimulatedScene scene = wallAt(2.0);
  const RgbImage dark = flatPattern(light.projector, 0);
  const RigSimulation simulation(scene, {dark, dark}, light, raysOf(scene.rig));
  const LitViews views = simulation.cast(0);
  const auto first = simulation.shoot(views, 0, 1, 1);
  EXPECT_EQ(simulation.shoot(views, 0, 1, 1)->images, first->images);
  EXPECT_FALSE(first->images[0] == first->images[1]);
  EXPECT_FALSE(first->images[0] == simulation.shoot(views, 0, 2, 1)->images[0]);
  EXPECT_FALSE(first->images[0] == simulation.shoot(views, 0, 1, 2)->images[0]);
  EXPECT_FALSE(first->images[0] == simulation.shoot(views, 1, 1, 1)->images[0]);
}

} // namespace
} // namespace pcl::acmap::test
