#include "atlas/chart_picture.h"
#include "atlas/rectangle_packing.h"
#include "atlas/texture_atlas.h"
#include "export/map_writers.h"
#include "temporary_folder.h"
#include "texturing/canvas_painting.h"
#include "texturing/intensity_greys.h"

#include <pcl/PCLPointField.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/random.h>
#include <pcl/texture/compact_map_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pcl::acmap::test {
namespace {

using Sizes = std::vector<Eigen::Vector2i>;

Sizes
randomSizes(std::size_t count, int maximum)
{
  Random random(5);
  Sizes sizes;
  for (std::size_t i = 0; i < count; ++i)
    sizes.emplace_back(1 + int(random.uniform(0, maximum)),
                       1 + int(random.uniform(0, maximum)));
  return sizes;
}

/** Checks by brute force that no two rectangles overlap; returns the filled share. */
double
expectPacked(const Sizes& sizes, const Packing& packing)
{
  std::vector<std::vector<bool>> used;
  double area = 0, filled = 0;
  for (const Eigen::Vector2i& page : packing.pages) {
    used.emplace_back(static_cast<std::size_t>(page.prod()));
    area += page.prod();
  }
  std::size_t overlaps = 0, outside = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const PackedPlace& place = packing.places[i];
    const Eigen::Vector2i page = packing.pages[place.page];
    if (place.corner.minCoeff() < 0 ||
        ((place.corner + sizes[i]).array() > page.array()).any()) {
      ++outside;
      continue;
    }
    filled += sizes[i].prod();
    for (int row = 0; row < sizes[i].y(); ++row)
      for (int column = 0; column < sizes[i].x(); ++column) {
        const auto at = static_cast<std::size_t>((place.corner.y() + row) * page.x() +
                                                 place.corner.x() + column);
        overlaps += used[place.page][at];
        used[place.page][at] = true;
      }
  }
  EXPECT_EQ(outside, 0U);
  EXPECT_EQ(overlaps, 0U);
  return filled / area;
}

TEST(RectanglePacking, NothingOverlapsAndPagesAreFull)
{
  const Sizes sizes = randomSizes(300, 60);
  const Packing packing = packedRectangles(sizes, 1, 256);
  EXPECT_GT(expectPacked(sizes, packing), 0.75);
  for (std::size_t i = 0; i + 1 < packing.pages.size(); ++i)
    EXPECT_EQ(packing.pages[i], Eigen::Vector2i(256, 256)) << "before the last";
  EXPECT_GT(packing.pages.size(), 3U);
}

TEST(RectanglePacking, PlacesAreMultiplesOfTheUnit)
{
  const Sizes sizes = randomSizes(100, 60);
  const Packing packing = packedRectangles(sizes, 16, 4096);
  expectPacked(sizes, packing);
  ASSERT_EQ(packing.pages.size(), 1U);
  for (const int side : packing.pages[0])
    EXPECT_EQ(side & (side - 1), 0) << side;
  for (const PackedPlace& place : packing.places) {
    EXPECT_EQ(place.corner.x() % 16, 0);
    EXPECT_EQ(place.corner.y() % 16, 0);
  }
}

TEST(RectanglePacking, SmallAndLargeOnes)
{
  EXPECT_TRUE(packedRectangles({}, 16, 4096).pages.empty());
  const Packing one = packedRectangles({{1, 1}}, 16, 4096);
  EXPECT_EQ(one.pages, Sizes({{16, 16}}));
  const Sizes sizes = {{3, 3}, {100, 2}, {32, 32}};
  const Packing packing = packedRectangles(sizes, 1, 32);
  expectPacked(sizes, packing);
  EXPECT_EQ(packing.pages, Sizes({{100, 2}, {32, 32}, {4, 4}}));
}

TextureChart
chartOf(int width, int height, const std::function<double(int, int)>& level)
{
  TextureChart chart;
  chart.texel_u = 0.02 * Eigen::Vector3d::UnitX();
  chart.texel_v = 0.02 * Eigen::Vector3d::UnitY();
  chart.colors.width = width;
  chart.colors.height = height;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      for (int k = 0; k < 3; ++k)
        chart.colors.values.push_back(
            static_cast<std::uint8_t>(std::lround(level(column, row) + 10 * k)));
  chart.kinds.assign(chart.colors.values.size() / 3, TexelKind::Seen);
  return chart;
}

ChartPicture
pictureWithin(const TextureChart& chart, double tolerance, double exposure = 1)
{
  PictureSettings settings;
  settings.tolerance = tolerance;
  settings.exposure = exposure;
  return pictureOf(chart, std::vector<bool>(chart.kinds.size(), true), settings);
}

TEST(ChartPicture, OneColourIsOneTexel)
{
  Random random(3);
  const TextureChart chart =
      chartOf(300, 70, [&](int, int) { return 90 + random.uniform(-2, 2); });
  const ChartPicture picture = pictureWithin(chart, 1.5);
  EXPECT_EQ(picture.halvings, 9);
  EXPECT_EQ(picture.image.values, (std::vector<std::uint8_t>{90, 100, 110}));
  EXPECT_EQ(pictureWithin(chart, 1.5, 2).image.values,
            (std::vector<std::uint8_t>{180, 200, 220}));
  EXPECT_EQ(pictureWithin(chart, 0).image.values, chart.colors.values);
}

TEST(ChartPicture, SlowColoursAreHalvedAndDetailsAreNot)
{
  const auto slow = [](int column, int) { return 100 + 20 * std::sin(0.05 * column); };
  const TextureChart plain = chartOf(400, 100, slow);
  const ChartPicture picture = pictureWithin(plain, 1.5);
  EXPECT_GE(picture.halvings, 2);
  EXPECT_LT(picture.halvings, 9);
  EXPECT_EQ(halvedSize(plain.colors, picture.halvings),
            Eigen::Vector2i(picture.image.width, picture.image.height));
  // a switch on the wall, which hardly counts in the root mean square of all texels
  const TextureChart detail = chartOf(400, 100, [&](int column, int row) {
    const bool is_switch = std::abs(column - 201) < 4 && std::abs(row - 51) < 4;
    return is_switch ? 200 : slow(column, row);
  });
  EXPECT_EQ(pictureWithin(detail, 1.5).halvings, 0);
}

TEST(ChartPicture, EnlargedItHasTheMeasuredError)
{
  Random random(8);
  TextureChart chart = chartOf(123, 77, [&](int column, int row) {
    return 100 + 25 * std::sin(0.04 * column) * std::cos(0.03 * row) +
           random.uniform(-1, 1);
  });
  const ChartPicture picture = pictureWithin(chart, 1.5, 1.6);
  ASSERT_GT(picture.halvings, 0);
  TextureChart large = chart;
  large.halvings = picture.halvings;
  enlarge(picture.image, 1.6, large);
  double sum = 0;
  for (std::size_t k = 0; k < chart.colors.values.size(); ++k)
    sum += std::pow(double(large.colors.values[k]) - chart.colors.values[k], 2);
  const double rms = std::sqrt(sum / static_cast<double>(chart.colors.values.size()));
  EXPECT_LE(rms, 1.5);
  EXPECT_GT(rms, 0.3);
}

TEST(ChartPicture, UnknownIsGreyInsideAndContinuedOutside)
{
  TextureChart chart = chartOf(16, 16, [](int, int) { return 40; });
  std::vector<bool> cover(chart.kinds.size(), true);
  for (std::size_t i = 0; i < 16; ++i) {
    chart.kinds[i] = TexelKind::None;           // the first row: never seen
    chart.kinds[15 * 16 + i] = TexelKind::None; // the last one: not in the polygon
    cover[15 * 16 + i] = false;
  }
  const ChartPicture picture = pictureOf(chart, cover, {});
  EXPECT_EQ(picture.image.at(5, 0)[0], unknown_grey);
  EXPECT_EQ(picture.image.at(5, 1)[0], 40);
  EXPECT_EQ(picture.image.at(5, 15)[0], 40);
}

/** A map of rectangles side by side, each with a chart. */
CompactMap
mapOf(const std::vector<TextureChart>& charts)
{
  CompactMap map;
  float place = 0;
  for (const TextureChart& chart : charts) {
    PlanePatch& plane = map.planes.emplace_back();
    const float width = 0.02F * static_cast<float>(chart.colors.width);
    const float height = 0.02F * static_cast<float>(chart.colors.height);
    plane.coefficients << 0, 0, -1, 1;
    plane.axis_u = Eigen::Vector3d::UnitX();
    plane.axis_v = Eigen::Vector3d::UnitY();
    plane.area = width * height;
    plane.polygons = {{{{place, 0, 1},
                        {place, height, 1},
                        {place + width, height, 1},
                        {place + width, 0, 1}},
                       {}}};
    map.charts.push_back(chart);
    map.charts.back().plane = map.planes.size() - 1;
    map.charts.back().origin = {place, 0, 1};
    place += width + 0.5F;
  }
  return map;
}

TEST(TextureAtlas, BordersAreContinuedByFourTexels)
{
  Random random(4);
  std::vector<TextureChart> charts;
  for (const Eigen::Vector2i& size : randomSizes(40, 50))
    charts.push_back(
        chartOf(size.x(), size.y(), [&](int, int) { return random.uniform(0, 230); }));
  const CompactMap map = mapOf(charts);
  const auto surfaces = surfacesOf(map);
  const TextureAtlas atlas = atlasOf(map, surfaces, -Eigen::Vector3d::UnitY(), 0);
  ASSERT_EQ(atlas.pages.size(), 1U);
  const RgbImage& page = atlas.pages[0];
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const Eigen::Vector2i corner = atlas.places[i].corner.cast<int>();
    const RgbImage& own = charts[i].colors;
    for (int row = -4; row < own.height + 4; ++row)
      for (int column = -4; column < own.width + 4; ++column)
        for (std::size_t k = 0; k < 3; ++k)
          wrong += page.at(corner.x() + column, corner.y() + row)[k] !=
                   own.at(std::clamp(column, 0, own.width - 1),
                          std::clamp(row, 0, own.height - 1))[k];
  }
  EXPECT_EQ(wrong, 0U);
}

TEST(TextureAtlas, ManyChartsHaveFewFilesAndOneMaterial)
{
  Random random(6);
  std::vector<TextureChart> charts;
  for (int i = 0; i < 1500; ++i) {
    const double level = random.uniform(30, 200);
    charts.push_back(chartOf(8 + i % 17, 5 + i % 9, [&](int, int) {
      return level + (i % 3 ? 0 : random.uniform(0, 30));
    }));
    charts.back().kinds[0] = TexelKind::Filled;
  }
  CompactMap map = mapOf(charts);
  map.charts.pop_back(); // a polygon without a chart
  const TemporaryFolder folder;
  EXPECT_THAT(
      saveCompactMap(folder.path("map"), map),
      testing::ElementsAre(
          "map.json", "texture_0.png", "kinds_0.png", "map.obj", "map.mtl", "map.glb"));
  const CompactMap back = loadCompactMap(folder.path("map"));
  ASSERT_EQ(back.charts.size(), 1499U);
  for (std::size_t i = 0; i < back.charts.size(); ++i) {
    EXPECT_EQ(back.charts[i].kinds, map.charts[i].kinds);
    if (i % 3 != 0) {
      EXPECT_EQ(back.charts[i].colors.values, map.charts[i].colors.values);
    }
  }
}

/** An atlas of pages of 256 x 256 with all texels. */
TextureAtlas
smallAtlasOf(const CompactMap& map)
{
  AtlasLimits limits;
  limits.longest_page = 256;
  return atlasOf(map, surfacesOf(map), -Eigen::Vector3d::UnitY(), 0, limits);
}

int
patternAt(int column, int row)
{
  return (column ^ row) & 127;
}

TEST(TextureAtlas, ASecondPageIsBegunWhenTheFirstIsFull)
{
  const CompactMap map = mapOf({chartOf(240, 140, patternAt),
                                chartOf(40, 30, patternAt),
                                chartOf(240, 130, patternAt)});
  const TextureAtlas atlas = smallAtlasOf(map);
  ASSERT_EQ(atlas.pages.size(), 2U);
  EXPECT_EQ(atlas.places[0].page, 0U);
  EXPECT_EQ(atlas.places[1].page, 0U) << "the first page has room for it";
  EXPECT_EQ(atlas.places[2].page, 1U);
  EXPECT_THAT(atlas.halvings, testing::Each(0));
  const TemporaryFolder folder;
  writeObj(folder.path("map.obj"), map, surfacesOf(map), {}, atlas);
  writeMtl(folder.path("map.mtl"), map, {"a.png", "b.png"}, false);
  const std::string obj = contentOf(folder.path("map.obj"));
  const std::size_t second = obj.find("usemtl page_1");
  EXPECT_LT(obj.find("usemtl page_0"), second);
  EXPECT_LT(obj.find("# plane 1"), second);
  EXPECT_GT(obj.find("# plane 2"), second);
  EXPECT_THAT(contentOf(folder.path("map.mtl")), testing::HasSubstr("map_Kd b.png"));
}

TEST(TextureAtlas, ALargeMapIsHalvedUntilItFits)
{
  // five pages would be needed for all texels, and no page is as wide as the last chart
  std::vector<TextureChart> charts(5, chartOf(240, 180, patternAt));
  charts.push_back(chartOf(300, 10, patternAt));
  const TextureAtlas atlas = smallAtlasOf(mapOf(charts));
  EXPECT_LE(atlas.pages.size(), 4U);
  EXPECT_THAT(atlas.halvings, testing::Each(1));
  for (const RgbImage& page : atlas.pages)
    EXPECT_LE(std::max(page.width, page.height), 256);
}

TEST(TextureAtlas, WithoutColoursNormalsShade)
{
  CompactMap map = mapOf({chartOf(20, 20, [](int, int) { return 128; }),
                          chartOf(20, 20, [](int, int) { return 128; })});
  map.charts.pop_back();
  map.charts[0].kinds.assign(400, TexelKind::None);
  map.planes[1].coefficients << 0, -1, 0, 1; // upwards
  const auto surfaces = surfacesOf(map);
  const TextureAtlas atlas = atlasOf(map, surfaces, -Eigen::Vector3d::UnitY(), 1.5);
  ASSERT_EQ(atlas.pages.size(), 1U);
  const auto levelOf = [&](std::size_t surface) {
    const Eigen::Vector2d at = atlas.coordinates(surface, {0, 0});
    const RgbImage& page = atlas.pages[0];
    return page.at(static_cast<int>(at.x() * page.width),
                   static_cast<int>(at.y() * page.height))[1];
  };
  EXPECT_GT(levelOf(1), levelOf(0) + 20) << "a floor is brighter than a wall";
  EXPECT_GT(levelOf(0), 60);
}

TEST(TextureAtlas, SameForEachNumberOfThreads)
{
  Random random(7);
  std::vector<TextureChart> charts;
  for (const Eigen::Vector2i& size : randomSizes(60, 80))
    charts.push_back(chartOf(
        size.x(), size.y(), [&](int c, int) { return c + random.uniform(0, 4); }));
  const CompactMap map = mapOf(charts);
  std::vector<std::uint8_t> first;
  for (const unsigned threads : {1U, 2U, 8U})
    withThreads(threads, [&] {
      const TextureAtlas atlas =
          atlasOf(map, surfacesOf(map), -Eigen::Vector3d::UnitY(), 1.5);
      ASSERT_EQ(atlas.pages.size(), 1U);
      if (first.empty())
        first = atlas.pages[0].values;
      EXPECT_TRUE(atlas.pages[0].values == first) << threads;
    });
}

TEST(DisplayExposure, BrightensDarkMapsAndClipsFewTexels)
{
  using texturing::displayExposure;
  EXPECT_EQ(displayExposure(CompactMap()), 16) << "nothing known: the limit";
  const auto exposureOf = [](const std::function<double(int, int)>& level) {
    return displayExposure(mapOf({chartOf(100, 100, level)}));
  };
  // green is 10, blue 20 brighter than red
  EXPECT_NEAR(exposureOf([](int, int) { return 100; }), 0.85 * 255 / 108, 0.01);
  EXPECT_EQ(exposureOf([](int, int) { return 230; }), 1) << "never darker";
  // a window of 4 % is brighter than all else, but its texels must not be clipped
  EXPECT_NEAR(exposureOf([](int column, int) { return column < 4 ? 180 : 40; }),
              255.0 / 200,
              0.01);
  // lamps of 0.5 % do not count
  EXPECT_NEAR(exposureOf([](int column, int row) {
                return column == 0 && row < 50 ? 230 : 100;
              }),
              0.85 * 255 / 108,
              0.01);
}

TEST(IntensityGreys, TheFirstViewDecidesTheScale)
{
  texturing::IntensityGreys greys;
  std::vector<float> values;
  for (int i = 0; i <= 100; ++i)
    values.push_back(static_cast<float>(10 * i));
  values.push_back(NAN);
  const auto first =
      greys.packed({values.data(), sizeof(float), PCLPointField::FLOAT32}, 102);
  EXPECT_EQ(first[0], 0U);
  EXPECT_EQ(first[99] & 255U, 230U);
  EXPECT_EQ(first[101], 0U) << "NaN";
  const std::vector<std::uint16_t> next = {990, 495, 5000};
  const auto second = greys.packed(
      {next.data(), sizeof(std::uint16_t), PCLPointField::UINT16}, next.size());
  EXPECT_EQ(second, (LargeVector<std::uint32_t>{0xe6e6e6, 0x737373, 0xffffff}));
}

} // namespace
} // namespace pcl::acmap::test
