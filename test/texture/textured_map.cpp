#include "textured_map.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

namespace pcl::acmap::test {

namespace {

TextureChart
makeChart(std::size_t plane,
          const Eigen::Vector3d& origin,
          const Eigen::Vector3d& texel_u,
          const Eigen::Vector3d& texel_v,
          std::int32_t width,
          std::int32_t height)
{
  TextureChart chart;
  chart.plane = plane;
  chart.origin = origin;
  chart.texel_u = texel_u;
  chart.texel_v = texel_v;
  chart.colors.width = width;
  chart.colors.height = height;
  for (std::int32_t row = 0; row < height; ++row)
    for (std::int32_t column = 0; column < width; ++column) {
      for (const int value : {40 + 4 * column, 40 + 5 * row, 40 + 20 * int(plane)})
        chart.colors.values.push_back(static_cast<std::uint8_t>(value));
      chart.kinds.push_back(TexelKind::Seen);
    }
  return chart;
}

PlanePatch
makePlane(const Eigen::Vector3d& normal,
          const Eigen::Vector3d& point,
          const std::vector<PlanePolygon>& polygons)
{
  PlanePatch plane;
  plane.coefficients << normal, -normal.dot(point);
  plane.center = point;
  plane.axis_u = normal.unitOrthogonal();
  plane.axis_v = normal.cross(plane.axis_u);
  plane.polygons = polygons;
  return plane;
}

Eigen::Vector2d
placeIn(const TextureChart& chart, const Eigen::Vector3d& point)
{
  Eigen::Matrix<double, 3, 2> axes;
  axes << chart.texel_u, chart.texel_v;
  return axes.colPivHouseholderQr().solve(point - chart.origin);
}

void
expectTexel(const ReadTriangle& triangle, const CompactMap& map)
{
  const TextureChart& chart = map.charts.at(triangle.chart);
  for (const Eigen::Vector3d& weights : {Eigen::Vector3d(1, 1, 1),
                                         Eigen::Vector3d(1, 0.1, 0.1),
                                         Eigen::Vector3d(0.1, 1, 0.1),
                                         Eigen::Vector3d(0.1, 0.1, 1)}) {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    for (int i = 0; i < 3; ++i) {
      point += weights[i] / weights.sum() * triangle.corners[i];
      place += weights[i] / weights.sum() * triangle.places[i];
    }
    place =
        place.cwiseProduct(Eigen::Vector2d(chart.colors.width, chart.colors.height));
    EXPECT_LT((placeIn(chart, point) - place).norm(), 0.02)
        << placeIn(chart, point).transpose() << " against " << place.transpose();
    EXPECT_GE(place.minCoeff(), 0);
    EXPECT_LE(place.x(), chart.colors.width);
    EXPECT_LE(place.y(), chart.colors.height);
  }
}

} // namespace

CompactMap
makeTexturedMap(const Eigen::Vector3d& place)
{
  const auto loop = [&](std::vector<Eigen::Vector3d> points) {
    std::vector<Eigen::Vector3f> moved;
    for (const Eigen::Vector3d& p : points)
      moved.push_back((p + place).cast<float>());
    return moved;
  };
  using V = Eigen::Vector3d;
  CompactMap map;
  map.planes = {makePlane(-V::UnitZ(),
                          place + V(0, 0, 5),
                          {{loop({{-1, -1, 5}, {-1, 1, 5}, {2, 1, 5}, {2, -1, 5}}),
                            {loop({{0, 0, 5}, {1, 0, 5}, {1, 0.5, 5}, {0, 0.5, 5}})}}}),
                makePlane(-V::UnitY(),
                          place + V(0, 1, 0),
                          {{loop({{-1, 1, 5},
                                  {-1, 1, 1},
                                  {2, 1, 1},
                                  {2, 1, 2},
                                  {0.5, 1, 2},
                                  {0.5, 1, 5}}),
                            {}}}),
                makePlane(V::UnitY(),
                          place + V(0, -1, 0),
                          {{loop({{-1, -1, 1}, {-1, -1, 5}, {2, -1, 5}}), {}}})};
  map.charts = {
      makeChart(0, place + V(-1, -1, 5), V(0.1, 0, 0), V(0, 0.1, 0), 30, 20),
      makeChart(1, place + V(-1, 1, 5), V(0.1, 0, 0), V(0, 0, -0.1), 30, 25),
      makeChart(1, place + V(-1, 1, 2.5), V(0.1, 0, 0), V(0, 0, -0.1), 30, 15)};
  map.charts[1].kinds[7] = TexelKind::Filled;
  map.charts[1].kinds[8] = TexelKind::None;
  std::fill_n(&map.charts[1].colors.values[3 * 8], 3, std::uint8_t{128});
  map.observations = {{0}, {0}, {}};
  map.trajectory.stamps = {0.5};
  map.trajectory.poses = {Eigen::Isometry3d::Identity()};
  return map;
}

std::vector<double>
areasOf(const CompactMap& map)
{
  EXPECT_EQ(map.charts.size(), 3u);
  return {6 - 0.5, 1.5 * 2.5, 1.5 * 1.5 + 1.5 * 1, 6};
}

void
expectSurfaces(const std::vector<ReadTriangle>& triangles, const CompactMap& map)
{
  std::vector<double> areas(map.charts.size() + 1);
  for (const ReadTriangle& triangle : triangles) {
    const auto& c = triangle.corners;
    const Eigen::Vector3d turn = 0.5 * (c[1] - c[0]).cross(c[2] - c[0]);
    const bool has_chart = triangle.chart != no_chart;
    areas.at(has_chart ? triangle.chart : map.charts.size()) += turn.norm();
    const std::size_t plane = has_chart ? map.charts.at(triangle.chart).plane : 2;
    const Eigen::Vector3d normal = map.planes[plane].coefficients.head<3>();
    EXPECT_GT(turn.normalized().dot(normal), 0.999);
    if (has_chart)
      expectTexel(triangle, map);
  }
  const std::vector<double> wanted = areasOf(map);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_NEAR(areas[i], wanted[i], 2e-3) << i;
}

} // namespace pcl::acmap::test
