#include "painted_maps.h"

#include <pcl/conversions.h>
#include <pcl/core/point_types.h>

#include <gtest/gtest.h>

#ifdef ACMAP_FEW_POINT_TYPES
#include <pcl/texture/impl/plane_texturing.hpp>
#endif

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Three views of the wall; one of them also looks down at the floor. */
std::vector<View>
views()
{
  const auto screens = wallAndFloor();
  return {lookAt(screens, {{0, 0, 0.3}}),
          lookAt(screens, {{0.5, 0, 0.6}, -0.15}),
          lookAt(screens, {{-0.4, -0.5, 0.4}, 0.1, -0.6})};
}

TEST(PlaneTexturing, TexelsHaveTheColoursOfTheirPlaces)
{
  Texturing texturing = texturingOf(planesOfWallAndFloor(), views());
  CompactMap map;
  texturing.texture(map);
  EXPECT_GT(expectSquares(map, 3), 2500u);
  const TexturingReport& report = texturing.getReport();
  EXPECT_EQ(report.observations, 3u);
  EXPECT_EQ(report.pinholes, 3u);
  EXPECT_EQ(report.splatted, 0u);
  EXPECT_EQ(report.charts, 2u);
  EXPECT_NEAR(static_cast<double>(report.texels), (3 * 2.4 + 3 * 2) / 4e-4, 400);
  EXPECT_EQ(report.seen, countOf(map, TexelKind::Seen));
  EXPECT_GT(report.seen, report.texels * 8 / 10);
  EXPECT_EQ(report.texel_size, 0.02);
  EXPECT_TRUE(report.remarks.empty()) << report.remarks.front();
  for (const double gain : report.gains)
    EXPECT_NEAR(gain, 1, 0.01);
}

TEST(PlaneTexturing, ChartsStandUprightAndLookAtTheOneWhoSees)
{
  const CompactMap map = painted(texturingOf(planesOfWallAndFloor(), views()));
  ASSERT_EQ(map.charts.size(), 2u);
  for (const TextureChart& chart : map.charts) {
    const Eigen::Vector3d normal = map.planes[chart.plane].coefficients.head<3>();
    const Eigen::Vector3d away = chart.texel_u.cross(chart.texel_v);
    EXPECT_NEAR(away.dot(normal), -4e-4, 1e-9);
    EXPECT_NEAR(chart.texel_u.norm(), 0.02, 1e-12);
    EXPECT_NEAR(chart.texel_v.norm(), 0.02, 1e-12);
    EXPECT_NEAR(
        map.planes[chart.plane].coefficients[3] + normal.dot(chart.origin), 0, 1e-6);
  }
  EXPECT_LT((map.charts[0].texel_v - Eigen::Vector3d(0, 0.02, 0)).norm(), 1e-8);
  EXPECT_LT((map.charts[1].texel_u - Eigen::Vector3d(0.02, 0, 0)).norm(), 1e-8);
  EXPECT_LT((map.charts[0].origin - Eigen::Vector3d(-1.5, -1.2, 3)).norm(), 1e-6);
  EXPECT_NEAR(map.charts[0].colors.width, 150, 1);
  EXPECT_NEAR(map.charts[0].colors.height, 120, 1);
}

/** Points on the wall with an intensity that rises with x, as a cloud in memory and as one
 * of a file; both without colour. */
TEST(PlaneTexturing, IntensityIsGreyWhereThereIsNoColour)
{
  const PointCloud<PointXYZI>::Ptr cloud(new PointCloud<PointXYZI>);
  for (int i = 0; i < 140; ++i)
    for (int j = 0; j < 100; ++j) {
      PointXYZI point;
      point.x = 0.02F * static_cast<float>(i) - 1.39F;
      point.y = 0.02F * static_cast<float>(j) - 0.99F;
      point.z = 3;
      point.intensity = 1000 * (point.x + 1.39F);
      cloud->push_back(point);
    }
  PlaneTexturing<PointXYZI> own;
  own.setTexelSize(0.02);
  own.setPlanes(planesOfWallAndFloor());
  own.addObservation(cloud);
  CompactMap map;
  own.texture(map);
  EXPECT_GT(own.getReport().seen, 13000U);
  EXPECT_EQ(own.getReport().colorless, 0U);
  forTexels(map,
            TexelKind::Seen,
            [&](const TextureChart&, const std::uint8_t* color, const auto& place) {
              const double level = 230 * (place.x() + 1.39) / (0.99 * 2.78);
              EXPECT_NEAR(color[0], std::clamp(level, 0.0, 230.0), 6);
              EXPECT_EQ(color[0], color[2]);
            });

  const PCLPointCloud2::Ptr file(new PCLPointCloud2);
  toPCLPointCloud2(*cloud, *file);
  PlaneTexturing<PointXYZRGB> loaded;
  loaded.setTexelSize(0.02);
  loaded.setPlanes(planesOfWallAndFloor());
  loaded.addObservationLoader([&]() -> std::optional<TexturedObservation> {
    return TexturedObservation{file, Eigen::Isometry3d::Identity(), 0, false};
  });
  CompactMap again;
  loaded.texture(again);
  EXPECT_EQ(again.charts[0].colors.values, map.charts[0].colors.values);
}

TEST(PlaneTexturing, MapsKnowTheirExposure)
{
  std::vector<View> dark = views();
  for (View& view : dark)
    for (PointXYZRGB& point : *view.cloud)
      for (std::uint8_t* const value : {&point.r, &point.g, &point.b})
        *value = static_cast<std::uint8_t>(*value / 4);
  const CompactMap bright_map = painted(texturingOf(planesOfWallAndFloor(), views()));
  const CompactMap dark_map = painted(texturingOf(planesOfWallAndFloor(), dark));
  EXPECT_GE(bright_map.exposure, 1);
  EXPECT_NEAR(dark_map.exposure, 4 * bright_map.exposure, 0.4) << bright_map.exposure;
}

TEST(PlaneTexturing, TurnedPolygonsGetTheSmallestRectangle)
{
  PlanePatch diamond =
      makePlane({0, 0, -1}, {{0, -1, 3}, {-1, 0, 3}, {0, 1, 3}, {1, 0, 3}});
  const CompactMap map = painted(texturingOf({diamond}, {}));
  ASSERT_EQ(map.charts.size(), 1u);
  EXPECT_NEAR(map.charts[0].colors.width, std::sqrt(2) / 0.02, 1.1);
  EXPECT_NEAR(map.charts[0].colors.height, std::sqrt(2) / 0.02, 1.1);
}

TEST(PlaneTexturing, WhoSawWhichPlaneIsTold)
{
  auto planes = planesOfWallAndFloor();
  planes.push_back(makePlane(
      {0, 0, -1}, {{40, 0, 50}, {40, 3, 50}, {43, 3, 50}, {43, 0, 50}})); // far away
  const CompactMap map = painted(texturingOf(planes, views()));
  ASSERT_EQ(map.observations.size(), 3u);
  EXPECT_EQ(map.observations[0], (std::vector<std::int32_t>{0, 1, 2}));
  // the other views are too close to the wall to see the floor
  EXPECT_EQ(map.observations[1], (std::vector<std::int32_t>{2}));
  EXPECT_TRUE(map.observations[2].empty());
  for (const TexelKind kind : map.charts[2].kinds)
    ASSERT_EQ(kind, TexelKind::None);
  EXPECT_EQ(map.trajectory.poses.size(), 3u);
  EXPECT_TRUE(map.trajectory.poses[1].isApprox(views()[1].T_map_camera, 1e-12));
}

/** The wall behind a magenta screen that is 1 m in front of it. */
std::vector<Screen>
screensWithBox()
{
  auto screens = wallAndFloor();
  screens.push_back({{-0.3, -0.3, 2}, {0.6, 0, 0}, {0, 0.6, 0}, [](const auto&) {
                       return Rgb{255, 0, 255};
                     }});
  return screens;
}

TEST(PlaneTexturing, WhatStandsBeforeAWallIsNotPaintedOnIt)
{
  Texturing texturing = texturingOf(planesOfWallAndFloor(), {lookAt(screensWithBox())});
  texturing.setFillDistance(0);
  const CompactMap map = painted(texturing);
  EXPECT_GT(expectSquares(map, 3), 1000u);
  std::size_t hidden = 0;
  for (const TexelKind kind : {TexelKind::Seen, TexelKind::Filled, TexelKind::None})
    forTexels(map, kind, [&](const auto& chart, const auto*, const auto& place) {
      if (chart.plane == 0 && std::abs(place.x()) < 0.44 &&
          std::abs(place.y()) < 0.44) {
        EXPECT_EQ(kind, TexelKind::None) << place.transpose();
        ++hidden;
      }
    });
  EXPECT_GT(hidden, 1800u);
}

/** A part of the wall around its centre. */
PlanePatch
middleOfWall()
{
  return makePlane({0, 0, -1},
                   {{-1, -0.9F, 3}, {-1, 0.9F, 3}, {1, 0.9F, 3}, {1, -0.9F, 3}});
}

TEST(PlaneTexturing, AnotherViewSeesBehind)
{
  const auto screens = screensWithBox();
  const CompactMap map = painted(texturingOf(
      planesOfWallAndFloor(), {lookAt(screens), lookAt(screens, {{1, 0, 0.8}, -0.4})}));
  std::size_t behind = 0;
  expectSquares(map, 3);
  forTexels(map,
            TexelKind::Seen,
            [&](const auto& chart, const auto* color, const auto& place) {
              EXPECT_FALSE(color[1] < 60) << "magenta at " << place.transpose();
              behind += chart.plane == 0 && std::abs(place.x()) < 0.4 &&
                                std::abs(place.y()) < 0.4
                            ? 1
                            : 0;
            });
  EXPECT_GT(behind, 500u);
}

TEST(PlaneTexturing, CoarseTexelsTakeNothingFromBeyondDepthEdges)
{
  for (const double aside : {0.0, 0.02, 0.04, 0.06}) { // different positions of the
                                                       // edges relative to the texels
    Texturing texturing = texturingOf({planesOfWallAndFloor()[0]},
                                      {lookAt(screensWithBox(), {{aside, 0, 1.2}})});
    texturing.setTexelSize(0.1); // about 12 pixels
    const CompactMap map = painted(texturing);
    EXPECT_GT(countOf(map, TexelKind::Seen), 100u);
    forTexels(map, TexelKind::Seen, [](const auto&, const auto* color, const auto& at) {
      EXPECT_GE(color[1], 105) << at.transpose();
    });
  }
}

double
meanRed(const CompactMap& map, double from, double to)
{
  double sum = 0, count = 0;
  forTexels(
      map, TexelKind::Seen, [&](const auto&, const auto* color, const auto& place) {
        if (place.x() < from || place.x() > to)
          return;
        sum += color[0];
        ++count;
      });
  EXPECT_GT(count, 100);
  return sum / count;
}

/** A plain wall in two views that overlap in the middle; the right one is darker. */
Texturing
twoExposures()
{
  std::vector<Screen> wall = wallAndFloor();
  wall[0].color = [](const auto&) { return Rgb{150, 140, 130}; };
  return texturingOf(
      {planesOfWallAndFloor()[0]},
      {lookAt(wall, {{-0.9, 0, 1}}), lookAt(wall, {{0.9, 0, 1}, 0, 0, 0.8})});
}

TEST(PlaneTexturing, ExposuresAreBalancedWithoutAStep)
{
  Texturing texturing = twoExposures();
  CompactMap map;
  texturing.texture(map);
  const std::vector<double>& gains = texturing.getReport().gains;
  ASSERT_EQ(gains.size(), 2u);
  EXPECT_NEAR(gains[1] / gains[0], 1 / 0.8, 0.02 / 0.8);
  EXPECT_NEAR(gains[1] * gains[0], 1, 0.02);
  int minimum = 255, maximum = 0;
  forTexels(map, TexelKind::Seen, [&](const auto&, const auto* color, const auto&) {
    minimum = std::min<int>(minimum, color[0]);
    maximum = std::max<int>(maximum, color[0]);
  });
  EXPECT_LE(maximum - minimum, 4);
  EXPECT_NEAR((maximum + minimum) / 2.0, 150 * std::sqrt(0.8), 3);
}

TEST(PlaneTexturing, ExposuresAreKeptOnDemand)
{
  Texturing texturing = twoExposures();
  texturing.setCorrectExposure(false);
  CompactMap map;
  texturing.texture(map);
  EXPECT_EQ(texturing.getReport().gains, (std::vector<double>{1, 1}));
  EXPECT_NEAR(meanRed(map, -1.5, -0.5), 150, 0.5);
  EXPECT_NEAR(meanRed(map, 0.5, 1.5), 120, 0.5);
}

TEST(PlaneTexturing, HolesAreFilledSoFarAndNoFurther)
{
  const auto screens = screensWithBox();
  const auto count = [&](int distance) {
    Texturing texturing = texturingOf({middleOfWall()}, {lookAt(screens)});
    texturing.setFillDistance(distance);
    CompactMap map;
    texturing.texture(map);
    const TexturingReport& report = texturing.getReport();
    EXPECT_GE(countOf(map, TexelKind::Filled), report.filled); // and rims
    return std::pair(report.filled, report.texels - report.seen - report.filled);
  };
  const auto none = count(0), two = count(2), five = count(5), all = count(1000);
  EXPECT_EQ(none.first, 0u);
  EXPECT_GT(two.first, 0u);
  // three rings of a hole with sides of about 44 texels
  EXPECT_NEAR(static_cast<double>(five.first - two.first), 3 * 4 * 44, 80);
  EXPECT_EQ(none.second, two.first + two.second);
  EXPECT_EQ(none.second, five.first + five.second);
  EXPECT_EQ(all.second, 0u);
}

TEST(PlaneTexturing, FilledTexelsTakeTheirNeighboursColours)
{
  std::vector<Screen> screens = screensWithBox();
  screens[0].color = [](const auto&) { return Rgb{90, 140, 30}; };
  const CompactMap map = painted(texturingOf({middleOfWall()}, {lookAt(screens)}));
  EXPECT_GT(countOf(map, TexelKind::Filled), 500u);
  forTexels(map, TexelKind::Filled, [&](const auto&, const auto* color, const auto&) {
    EXPECT_EQ(color[0], 90);
    EXPECT_EQ(color[1], 140);
    EXPECT_EQ(color[2], 30);
  });
  forTexels(map, TexelKind::None, [&](const auto&, const auto* color, const auto&) {
    EXPECT_EQ(color[0], 128);
  });
}

TEST(PlaneTexturing, HolesOfAPolygonStayUnknown)
{
  auto planes = planesOfWallAndFloor();
  planes[0].polygons[0].holes = {
      {{-0.5F, -0.5F, 3}, {0.5F, -0.5F, 3}, {0.5F, 0.5F, 3}, {-0.5F, 0.5F, 3}}};
  Texturing texturing = texturingOf(planes, views());
  CompactMap map;
  texturing.texture(map);
  EXPECT_NEAR(static_cast<double>(texturing.getReport().texels),
              (3 * 2.4 - 1 + 3 * 2) / 4e-4,
              400);
  for (const TexelKind kind : {TexelKind::Seen, TexelKind::Filled})
    forTexels(map, kind, [&](const auto& chart, const auto*, const auto& place) {
      const double depth = 0.5 - place.template head<2>().cwiseAbs().maxCoeff();
      if (chart.plane == 0) {
        EXPECT_LT(depth, kind == TexelKind::Seen ? 1e-6 : 0.02 + 1e-6);
      }
    });
  expectSquares(map, 3);
}

TEST(PlaneTexturing, TilesHaveTheColoursOfTheWhole)
{
  Texturing texturing = texturingOf(planesOfWallAndFloor(), views());
  texturing.setFillDistance(0);
  const CompactMap whole = painted(texturing);
  for (const int size : {16, 33, 64}) {
    texturing.setMaximumTextureSize(size);
    const CompactMap tiled = painted(texturing);
    EXPECT_GT(tiled.charts.size(), 6u);
    EXPECT_EQ(countOf(tiled, TexelKind::Seen), countOf(whole, TexelKind::Seen));
    std::size_t differing = 0;
    forTexels(tiled,
              TexelKind::Seen,
              [&](const auto& chart, const auto* color, const auto& place) {
                EXPECT_LE(std::max(chart.colors.width, chart.colors.height), size);
                const TextureChart& all = whole.charts[chart.plane];
                const Eigen::Vector3d way = place - all.origin;
                const auto column = static_cast<int>(way.dot(all.texel_u) / 4e-4);
                const auto row = static_cast<int>(way.dot(all.texel_v) / 4e-4);
                ASSERT_EQ(kindOf(all, column, row), TexelKind::Seen);
                for (int k = 0; k < 3; ++k)
                  differing +=
                      std::abs(color[k] - all.colors.at(column, row)[k]) > 1 ? 1 : 0;
              });
    EXPECT_EQ(differing, 0u);
  }
}

TEST(PlaneTexturing, SameBytesForAnyThreadsAndAgain)
{
  Texturing texturing = texturingOf(planesOfWallAndFloor(), views());
  texturing.setNumberOfThreads(1);
  const CompactMap once = painted(texturing);
  EXPECT_GT(countOf(once, TexelKind::Seen), 1000u);
  expectSame(painted(texturing), once);
  for (const unsigned threads : {2U, 8U, 0U}) {
    texturing.setNumberOfThreads(threads);
    expectSame(painted(texturing), once);
  }
}

/** Points on the wall, about \a spacing metres apart. */
View
sparseView(double spacing)
{
  View view;
  view.cloud.reset(new PointCloud<PointXYZRGB>);
  for (double x = -1.45; x < 1.5; x += spacing)
    for (double y = -1.15; y < 1.2; y += spacing) {
      PointXYZRGB point;
      point.r = 200;
      point.g = 100;
      point.b = 50;
      point.x = static_cast<float>(x + 0.2 * spacing * std::sin(37 * y));
      point.y = static_cast<float>(y + 0.2 * spacing * std::sin(41 * x));
      point.z = 3;
      view.cloud->push_back(point);
    }
  return view;
}

TEST(PlaneTexturing, TexelsAreNoFinerThanHalfTheSpacingOfPoints)
{
  for (const double spacing : {0.01, 0.1, 0.25}) {
    const View view = sparseView(spacing);
    std::vector<PlanePatch> planes = {planesOfWallAndFloor().front()};
    planes.front().support = view.cloud->size();
    planes.front().area = 3 * 2.4;
    Texturing texturing = texturingOf(planes, {view});
    texturing.setTexelSize(0);
    const TexturingReport report = reportOf(texturing);
    EXPECT_GE(report.texel_size, 0.45 * spacing);
    EXPECT_LE(report.texel_size, 0.7 * spacing);
    EXPECT_GT(report.seen + report.filled, report.texels * 9 / 10) << spacing;
    texturing.setTexelSize(0.05);
    EXPECT_EQ(reportOf(texturing).texel_size, 0.05);
  }
}

TEST(PlaneTexturing, TexelsOfImagesAreTheirPixelsHoweverFewPointsAPlaneHas)
{
  std::vector<PlanePatch> planes = planesOfWallAndFloor();
  for (PlanePatch& plane : planes) {
    plane.support = 30;
    plane.area = 6;
  }
  Texturing texturing = texturingOf(planes, views());
  texturing.setTexelSize(0);
  EXPECT_NEAR(
      reportOf(texturing).texel_size, 2.7 / 210, 0.001); // the wall is 2.7 m away
}

TEST(PlaneTexturing, AutomaticTexelsAreAtMostEightMillion)
{
  const PlanePatch wide =
      makePlane({0, 0, -1}, {{-40, -40, 3}, {-40, 40, 3}, {40, 40, 3}, {40, -40, 3}});
  Texturing texturing = texturingOf({wide}, {lookAt(wallAndFloor())});
  texturing.setTexelSize(0);
  const TexturingReport report = reportOf(texturing);
  EXPECT_LE(report.texels, std::size_t{1} << 23);
  EXPECT_GT(report.texels, std::size_t{7} << 20);
  EXPECT_TRUE(report.remarks.empty());
}

/** Share of the seen texels of the wall inside of squares that have another colour. */
double
wrongSquares(const CompactMap& map)
{
  double wrong = 0, all = 0;
  forTexels(map, TexelKind::Seen, [&](const auto&, const auto* color, const auto& at) {
    const auto isInside = [](double along) {
      return std::abs(along / square - std::floor(along / square) - 0.5) < 0.35;
    };
    if (!isInside(at.x()) || !isInside(at.y()))
      return;
    const Rgb truth = wallColor(at);
    ++all;
    wrong += std::abs(color[0] - truth[0]) > 40 ? 1 : 0;
  });
  EXPECT_GT(all, 1000);
  return wrong / all;
}

/** The wall, whose squares are 10 cm, in five views, of which one was taken 3 cm beside the
 * place that its pose says. */
TEST(PlaneTexturing, ViewsWithWrongPosesAreMovedOntoTheOthers)
{
  std::vector<View> seen;
  for (const double aside : {-0.4, -0.2, 0.0, 0.2, 0.4})
    seen.push_back(lookAt(wallAndFloor(), {{aside, 0, 0.8}}));
  const std::vector<PlanePatch> wall = {planesOfWallAndFloor().front()};
  Texturing exact = texturingOf(wall, seen);
  exact.setTexelSize(0.01);
  EXPECT_LT(wrongSquares(painted(exact)), 0.001);
  seen[2] = lookAt(wallAndFloor(), {{0.03, 0, 0.8}}); // of the nearest part of the wall
  seen[2].T_map_camera.translation().x() = 0;
  Texturing moved = texturingOf(wall, seen);
  moved.setTexelSize(0.01);
  EXPECT_LT(wrongSquares(painted(moved)), 0.02);
}

/** Stripes of 4 cm on the wall in two views that agree: neither is blurred by the other. */
TEST(PlaneTexturing, ARegionShowsOneView)
{
  std::vector<Screen> striped = wallAndFloor();
  striped[0].color = [](const Eigen::Vector3d& at) {
    return std::fmod(std::floor(at.x() / 0.04) + 1000, 2) == 0 ? Rgb{220, 220, 220}
                                                               : Rgb{40, 40, 40};
  };
  Texturing texturing = texturingOf({middleOfWall()},
                                    {lookAt(striped, {{0, 0, 2}}),
                                     lookAt(striped, {{0.2, 0.1, -3}}),
                                     lookAt(striped, {{-0.2, 0.1, -3}})});
  texturing.setTexelSize(0.005);
  const CompactMap map = painted(texturing);
  double off = 0, count = 0;
  forTexels(map, TexelKind::Seen, [&](const auto&, const auto* color, const auto& at) {
    if (at.template head<2>().cwiseAbs().maxCoeff() > 0.2)
      return; // there the near view looks
    const double share = at.x() / 0.04 - std::floor(at.x() / 0.04);
    if (std::abs(share - 0.5) > 0.3)
      return;
    off += std::abs(color[0] - striped[0].color(at)[0]);
    ++count;
  });
  EXPECT_GT(count, 1000);
  EXPECT_LT(off / count, 15); // the mean of the far views is grey, 90 off
}

/** Points on the wall, of two stations in turn, the second of which saw everything darker. */
PCLPointCloud2::Ptr
twoStations(bool are_named)
{
  PointCloud<PointXYZRGBNormalView> points;
  for (int i = 0; i < 280; ++i)
    for (int j = 0; j < 200; ++j) {
      PointXYZRGBNormalView point;
      const int station = (7 * i + 5 * j) % 11 < 5 ? 1 : 0;
      point.x = 0.01F * static_cast<float>(i) - 1.4F;
      point.y = 0.01F * static_cast<float>(j) - 1;
      point.z = 3;
      point.r = point.g = point.b = station == 1 ? 120 : 200;
      point.view = station;
      points.push_back(point);
    }
  const PCLPointCloud2::Ptr cloud(new PCLPointCloud2);
  toPCLPointCloud2(points, *cloud);
  if (!are_named)
    for (PCLPointField& field : cloud->fields)
      if (field.name == "view")
        field.name = "other";
  return cloud;
}

/** Mean step between neighbouring texels. */
double
stepsOf(const CompactMap& map)
{
  double sum = 0, count = 0;
  for (const TextureChart& chart : map.charts)
    for (int row = 0; row < chart.colors.height; ++row)
      for (int column = 0; column + 1 < chart.colors.width; ++column)
        if (kindOf(chart, column, row) == TexelKind::Seen &&
            kindOf(chart, column + 1, row) == TexelKind::Seen) {
          sum += std::abs(chart.colors.at(column, row)[0] -
                          chart.colors.at(column + 1, row)[0]);
          ++count;
        }
  EXPECT_GT(count, 1000);
  return sum / count;
}

TEST(PlaneTexturing, BrightAndDarkPointsOfStationsDoNotAlternate)
{
  for (const bool are_named : {true, false}) {
    Texturing texturing;
    texturing.setTexelSize(0.01);
    texturing.setPlanes({middleOfWall()});
    texturing.addObservationLoader([&]() -> std::optional<TexturedObservation> {
      return TexturedObservation{
          twoStations(are_named), Eigen::Isometry3d::Identity(), 0, false};
    });
    CompactMap map;
    texturing.texture(map);
    const TexturingReport& report = texturing.getReport();
    EXPECT_EQ(report.observations, 1U);
    ASSERT_EQ(report.gains.size(), are_named ? 2U : 1U);
    if (are_named) {
      EXPECT_NEAR(report.gains[1] / report.gains[0], 200.0 / 120, 0.05);
    }
    EXPECT_GT(report.seen, report.texels * 99 / 100);
    EXPECT_LT(stepsOf(map), are_named ? 1 : 10); // of the points it is 40
  }
}

} // namespace
} // namespace pcl::acmap::test
