#include "pattern/pattern_lines.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

RgbImage
blank(int width, int height)
{
  PatternLaw law;
  law.width = width;
  law.height = height;
  return paintLines(law, {});
}

bool
isLit(const RgbImage& image, int column, int row)
{
  return image.at(column, row)[0] != 0;
}

TEST(PatternRaster, LinesAlongTheAxesHaveTheirWidthEverywhere)
{
  for (int width = 1; width <= 6; ++width)
    for (const double distance : {0.0, 0.5, 3.25, -7.8}) {
      RgbImage image = blank(64, 48);
      paintLine({0, distance, width, {200, 0, 0}}, image);
      RgbImage turned = blank(64, 48);
      paintLine({M_PI / 2, distance, width, {200, 0, 0}}, turned);
      for (int column = 0; column < 64; ++column) {
        int lit = 0;
        for (int row = 0; row < 48; ++row)
          lit += isLit(image, column, row) ? 1 : 0;
        ASSERT_EQ(lit, width) << distance;
      }
      for (int row = 0; row < 48; ++row) {
        int lit = 0;
        for (int column = 0; column < 64; ++column)
          lit += isLit(turned, column, row) ? 1 : 0;
        ASSERT_EQ(lit, width) << distance;
      }
    }
}

TEST(PatternRaster, PixelsAreThoseWhoseCentresAreWithinTheBand)
{
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const PatternLine line{random.uniform(0, M_PI),
                           random.uniform(-40, 40),
                           1 + static_cast<int>(random.uniform(0, 8)),
                           {255, 255, 255}};
    RgbImage image = blank(63, 48);
    paintLine(line, image);
    for (int row = 0; row < 48; ++row)
      for (int column = 0; column < 63; ++column) {
        const double way = -std::sin(line.angle) * (column - 31.0) +
                           std::cos(line.angle) * (row - 23.5) - line.distance;
        const double to_rim = std::abs(way) - 0.5 * line.width;
        if (std::abs(to_rim) > 1e-3) { // closer pixels can depend on the rounding of
                                       // normals
          ASSERT_EQ(isLit(image, column, row), to_rim < 0)
              << line.angle << " " << line.distance << " " << column << " " << row;
        }
      }
  }
}

TEST(PatternRaster, LinesSideBySideLeaveNoGapAndDoNotOverlap)
{
  for (const double angle : {0.0, 0.4, M_PI / 4, 1.3, M_PI / 2, 2.0, 3.1}) {
    std::vector<int> hits(64 * 48);
    for (int i = -20; i <= 20; ++i) {
      RgbImage image = blank(64, 48);
      paintLine({angle, 3.0 * i, 3, {9, 9, 9}}, image);
      for (std::size_t p = 0; p < hits.size(); ++p)
        hits[p] += image.values[3 * p] != 0 ? 1 : 0;
    }
    EXPECT_EQ(hits, std::vector<int>(64 * 48, 1)) << angle;
  }
}

TEST(PatternRaster, LaterLinesCoverEarlierOnes)
{
  PatternLaw law;
  law.width = 16;
  law.height = 16;
  const RgbImage image =
      paintLines(law, {{0, 0, 4, {10, 20, 30}}, {M_PI / 2, 0, 4, {40, 50, 60}}});
  EXPECT_EQ(image.at(8, 8)[0], 40);
  EXPECT_EQ(image.at(8, 8)[2], 60);
  EXPECT_EQ(image.at(0, 8)[0], 10);
  EXPECT_EQ(image.at(0, 0)[0], 0);
  EXPECT_DOUBLE_EQ(coverageOf(image), (2 * 16 * 4 - 16) / 256.0);
}

TEST(PatternRaster, LinesBesideTheImageLeaveItBlack)
{
  RgbImage image = blank(16, 16);
  for (const double angle : {0.0, 0.5, M_PI / 2, 3.0})
    for (const double distance : {-30.0, 30.0})
      paintLine({angle, distance, 6, {255, 255, 255}}, image);
  EXPECT_EQ(coverageOf(image), 0.0);
}

} // namespace
} // namespace pcl::acmap::test
