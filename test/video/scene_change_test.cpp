#include "scene_change.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr int width = 320;
constexpr int height = 240;

/** \brief Stripes of 7 pixels with noise.
 * \param[in] sigma standard deviation of the noise, grey levels */
CameraImage
stripes(int shift, double sigma, std::uint64_t seed, int channels = 1)
{
  Random random(seed);
  CameraImage image{width, height, channels, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) {
        const double level = ((x + shift + y / 2) / 7) % 2 == 0 ? 60 : 170;
        const double value = level + sigma * random.normal();
        image.values.push_back(static_cast<std::uint8_t>(
            std::lround(std::min(255.0, std::max(0.0, value)))));
      }
  return image;
}

TEST(SceneChange, NoiseIsLittle)
{
  EXPECT_EQ(sceneChange(stripes(0, 0, 1), stripes(0, 0, 1)), 0);
  EXPECT_LT(sceneChange(stripes(0, 3, 1), stripes(0, 3, 2)), 2);
  EXPECT_LT(sceneChange(stripes(0, 8, 1, 3), stripes(0, 8, 2, 3)), 4);
}

TEST(SceneChange, AMotionOfAPixelIsMuch)
{
  EXPECT_GT(sceneChange(stripes(0, 3, 1), stripes(1, 3, 2)), 8);
}

TEST(SceneChange, AnObjectThatMovesIsSeenAndAFlyIsNot)
{
  const CameraImage before = stripes(0, 2, 1);
  const auto withSpot = [&](int side) {
    CameraImage image = stripes(0, 2, 2);
    for (int y = 80; y < 80 + side; ++y)
      for (int x = 80; x < 80 + side; ++x)
        image.values[static_cast<std::size_t>(y * width + x)] = 255;
    return image;
  };
  EXPECT_LT(sceneChange(before, withSpot(16)), 4);
  EXPECT_GT(sceneChange(before, withSpot(40)), 20);
}

TEST(SceneChange, ALampThatFlickersIsSeen)
{
  CameraImage after = stripes(0, 2, 2);
  for (std::uint8_t& value : after.values)
    value = static_cast<std::uint8_t>(std::min(255, value + 6));
  EXPECT_GT(sceneChange(stripes(0, 2, 1), after), 5);
}

TEST(SceneChange, ImagesOfAnySizeAreCompared)
{
  const CameraImage small{3, 2, 1, {10, 10, 10, 10, 10, 10}};
  const CameraImage other{3, 2, 1, {16, 16, 16, 16, 16, 16}};
  EXPECT_DOUBLE_EQ(sceneChange(small, other), 6);
  EXPECT_EQ(sceneChange({}, {}), 0);
  EXPECT_TRUE(std::isinf(sceneChange(small, stripes(0, 0, 1))));
}

} // namespace
} // namespace pcl::acmap::test
