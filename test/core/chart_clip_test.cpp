#include <pcl/core/impl/chart_clip.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;
using Corners = std::vector<ChartCorner>;

/** \brief A chart of 40 x 20 texels of 5 cm, oblique in space. */
TextureChart
slantedChart()
{
  const Eigen::Quaterniond turn = Eigen::AngleAxisd(0.7, Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(0.4, Vector3d::UnitZ());
  TextureChart chart;
  chart.origin = {10, -4, 7};
  chart.texel_u = turn * Vector3d(0.05, 0, 0);
  chart.texel_v = turn * Vector3d(0, 0.05, 0);
  chart.colors.width = 40;
  chart.colors.height = 20;
  return chart;
}

Vector3d
at(const TextureChart& chart, double column, double row)
{
  return chart.origin + column * chart.texel_u + row * chart.texel_v;
}

Vector3d
turningArea(const Corners& corners)
{
  Vector3d area = Vector3d::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
    area += (corners[i - 1].point - corners[0].point)
                .cross(corners[i].point - corners[0].point) /
            2;
  return area;
}

TEST(ChartClip, LeavesATriangleInsideAsItIs)
{
  const TextureChart chart = slantedChart();
  const Corners part =
      ChartClip(chart).clipped({at(chart, 1, 2), at(chart, 30, 2), at(chart, 5, 20)});
  ASSERT_EQ(part.size(), 3u);
  EXPECT_NEAR((part[1].place - Eigen::Vector2d(30, 2)).norm(), 0, 1e-9);
  EXPECT_EQ(part[2].point, at(chart, 5, 20));
}

TEST(ChartClip, ATriangleAroundGivesTheWholeRectangle)
{
  const TextureChart chart = slantedChart();
  const Corners part = ChartClip(chart).clipped(
      {at(chart, -100, -10), at(chart, 200, -10), at(chart, 20, 300)});
  EXPECT_NEAR(turningArea(part).norm(), 2 * 1, 1e-9);
}

TEST(ChartClip, WhatLiesBesideIsNothing)
{
  const TextureChart chart = slantedChart();
  EXPECT_TRUE(ChartClip(chart)
                  .clipped({at(chart, 41, 0), at(chart, 60, 0), at(chart, 41, 20)})
                  .empty());
}

/** \brief Random triangles clipped at four tiles add up to the triangle clipped at one
 * chart that covers all of them. */
TEST(ChartClip, TilesMakeUpTheWholeAndTurnAsTheTriangleDoes)
{
  const TextureChart whole = slantedChart();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> column(-20, 60), row(-10, 30);
  for (int round = 0; round < 200; ++round) {
    const std::array<Vector3d, 3> triangle = {at(whole, column(random), row(random)),
                                              at(whole, column(random), row(random)),
                                              at(whole, column(random), row(random))};
    const Vector3d turn = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    Vector3d sum = Vector3d::Zero();
    for (const int left : {0, 20})
      for (const int top : {0, 10}) {
        TextureChart tile = whole;
        tile.origin = at(whole, left, top);
        tile.colors.width = 20;
        tile.colors.height = 10;
        const Corners part = ChartClip(tile).clipped(triangle);
        EXPECT_GE(turningArea(part).dot(turn), -1e-12);
        sum += turningArea(part);
        for (const ChartCorner& corner : part)
          EXPECT_NEAR(
              (at(tile, corner.place.x(), corner.place.y()) - corner.point).norm(),
              0,
              0.002); // the tolerance of 0.01 texels
      }
    const Vector3d wanted = turningArea(ChartClip(whole).clipped(triangle));
    EXPECT_NEAR((sum - wanted).norm(), 0, 0.003) << round;
  }
}

/** \brief Error message for a chart with texels of 10 cm after a change. */
template <typename Change>
std::string
faultAfter(const Change& change)
{
  TextureChart chart;
  chart.texel_u = {0.1, 0, 0};
  chart.texel_v = {0, 0.1, 0};
  chart.colors.width = 4;
  chart.colors.height = 3;
  change(chart);
  return faultOfFrame(chart);
}

TEST(ChartFrame, ASoundOneHasNoFault)
{
  EXPECT_EQ(faultOfFrame(slantedChart()), "");
  for (const double side : {1.1e-6, 1.0, 999.0})
    EXPECT_EQ(faultAfter([&](TextureChart& chart) { chart.texel_u.x() = side; }), "");
  EXPECT_EQ(faultAfter([](TextureChart& chart) {
              chart.texel_u = {0.2e-3, 0.1, 0};
            }),
            "");
  EXPECT_EQ(faultAfter([](TextureChart& chart) {
              chart.colors.width = 1 << 14;
              chart.colors.height = 1 << 14;
            }),
            "");
}

TEST(ChartFrame, SidesThatAreTooShortOrTooLongAreNamed)
{
  for (const double side : {0.0, 0.9e-6, 1001.0, 1e200, double(INFINITY), double(NAN)})
    for (const auto vector : {&TextureChart::texel_u, &TextureChart::texel_v})
      EXPECT_NE(faultAfter([&](TextureChart& chart) {
                  (chart.*vector) *= 10 * side;
                }).find("with a side"),
                std::string::npos)
          << side;
}

TEST(ChartFrame, TexelsThatAreThinAreNamed)
{
  for (const double across : {0.0, 1e-20, 0.09e-3, -0.09e-3})
    EXPECT_EQ(faultAfter([&](TextureChart& chart) {
                chart.texel_u = {across, 0.1, 0};
              }),
              "has texels without an area")
        << across;
}

TEST(ChartFrame, OriginAndSizeAreChecked)
{
  EXPECT_EQ(faultAfter([](TextureChart& chart) { chart.origin.y() = NAN; }),
            "has an origin that is not finite");
  for (const std::int32_t width : {0, -1, 1 << 28})
    EXPECT_NE(faultAfter([&](TextureChart& chart) {
                chart.colors.width = width;
              }).find("2^28 are legal"),
              std::string::npos);
}

} // namespace
} // namespace pcl::acmap::test
