#include "pattern/image_fit.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** \brief An image whose pixels encode their positions. */
RgbImage
ruler(int width, int height)
{
  RgbImage image{width, height, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      for (const int value : {column + 1, row + 1, 255})
        image.values.push_back(static_cast<std::uint8_t>(value));
  return image;
}

TEST(PatternFit, SameSizeIsUntouched)
{
  const RgbImage image = ruler(200, 150);
  EXPECT_EQ(fitImage(image, 200, 150).values, image.values);
}

TEST(PatternFit, TheLargestPlaceOfItsShapeInTheMiddle)
{
  const auto expectPlace =
      [](const RgbImage& image, int w, int h, ImagePlace expected) {
        const ImagePlace place = placeOf(image, w, h);
        EXPECT_EQ(place.x, expected.x);
        EXPECT_EQ(place.y, expected.y);
        EXPECT_EQ(place.width, expected.width);
        EXPECT_EQ(place.height, expected.height);
      };
  expectPlace({1024, 768, {}}, 1920, 1080, {240, 0, 1440, 1080});
  expectPlace({1024, 768, {}}, 800, 600, {0, 0, 800, 600});
  expectPlace({1024, 768, {}}, 768, 1024, {0, 224, 768, 576});
  expectPlace({8192, 16, {}}, 640, 480, {0, 239, 640, 1});
  expectPlace({1, 8192, {}}, 640, 480, {319, 0, 1, 480});
}

TEST(PatternFit, PixelsAreThoseUnderTheCentres)
{
  const RgbImage image = ruler(10, 8);
  const RgbImage larger = fitImage(image, 35, 24); // scaled by three, with 2 black
                                                   // columns on the left
  for (int row = 0; row < 24; ++row)
    for (int column = 0; column < 35; ++column) {
      const bool is_black = column < 2 || column >= 32;
      ASSERT_EQ(larger.at(column, row)[0], is_black ? 0 : (column - 2) / 3 + 1);
      ASSERT_EQ(larger.at(column, row)[1], is_black ? 0 : row / 3 + 1);
    }
  const RgbImage smaller = fitImage(ruler(30, 9), 10, 3);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 10; ++column) {
      ASSERT_EQ(smaller.at(column, row)[0], 3 * column + 2);
      ASSERT_EQ(smaller.at(column, row)[1], 3 * row + 2);
    }
}

TEST(PatternFit, ImagesThatAreNoneAreRefused)
{
  EXPECT_THROW(fitImage({}, 10, 10), BadArgumentException);
  EXPECT_THROW(fitImage({2, 2, std::vector<std::uint8_t>(11)}, 10, 10),
               BadArgumentException);
  EXPECT_THROW(fitImage({-1, -1, std::vector<std::uint8_t>(3)}, 10, 10),
               BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
