#include "map_camera.h"
#include "map_lines.h"
#include "room_map.h"
#include "scale_bar.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;

double
areaOf(const MapFaces& part)
{
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const auto& face : part.faces)
    for (std::size_t i = 2; i < face.size(); ++i) {
      const auto at = [&](std::size_t k) {
        return part.points[static_cast<std::size_t>(face[k])];
      };
      sum += (at(i - 1) - at(0)).cross(at(i) - at(0)) / 2;
    }
  return sum.norm();
}

MapFrame
frameOfMap(const CompactMap& map)
{
  return frameOf(map, samplesOf(facesOf(map)), {});
}

/** \brief The rotated room without charts. */
CompactMap
turnedRoom(const Eigen::AngleAxisd& turn)
{
  CompactMap map = makeRoomMap();
  map.charts.clear();
  for (PlanePatch& plane : map.planes) {
    plane.coefficients.head<3>() = turn * Vector3d(plane.coefficients.head<3>());
    for (PlanePolygon& polygon : plane.polygons) {
      for (Eigen::Vector3f& point : polygon.outer)
        point = turn.cast<float>() * point;
      for (auto& hole : polygon.holes)
        for (Eigen::Vector3f& point : hole)
          point = turn.cast<float>() * point;
    }
  }
  return map;
}

TEST(MapFaces, ChartsCutPolygonsIntoPartsThatMakeUpTheWhole)
{
  const CompactMap map = makeRoomMap();
  const double wanted[] = {6 * 2.5 - 2, 10, 15, 8, 24, 24};
  std::vector<double> areas(6);
  std::size_t floor_parts = 0;
  for (const MapFaces& part : cutFaces(map, facesOf(map))) {
    areas[part.plane] += areaOf(part);
    floor_parts += part.plane == 4;
    ASSERT_EQ(part.places.size(), part.points.size());
    for (std::size_t i = 0; i < part.points.size(); ++i) {
      const TextureChart& chart = static_cast<const TextureChart&>(*part.chart);
      EXPECT_GT(part.places[i].minCoeff(), -1e-5);
      EXPECT_LT(part.places[i].maxCoeff(), 1 + 1e-5);
      const Vector3d point = chart.origin +
                             part.places[i].x() * chart.colors.width * chart.texel_u +
                             part.places[i].y() * chart.colors.height * chart.texel_v;
      EXPECT_NEAR((point - part.points[i].cast<double>()).norm(), 0, 1e-5);
    }
  }
  EXPECT_EQ(floor_parts, 2u);
  for (std::size_t plane = 0; plane < 6; ++plane)
    EXPECT_NEAR(areas[plane], wanted[plane], 1e-4) << plane;
}

TEST(MapFaces, WhatNoChartCoversIsLeftOut)
{
  CompactMap map = makeRoomMap();
  map.charts.erase(map.charts.end() - 1);
  double area = 0;
  for (const MapFaces& part : cutFaces(map, facesOf(map)))
    if (part.plane == 4)
      area += areaOf(part);
  EXPECT_NEAR(area, 12, 1e-4);
}

TEST(MapFrame, UpIsMinusYUntilCamerasOrLevelPlanesTellOtherwise)
{
  CompactMap map = makeRoomMap();
  EXPECT_EQ(frameOfMap(map).up, -Vector3d::UnitY());
  map.trajectory = makeRoomWay();
  EXPECT_EQ(frameOfMap(map).up, -Vector3d::UnitY());

  const Eigen::AngleAxisd tilt(0.6, Vector3d::UnitX());
  EXPECT_LT((frameOfMap(turnedRoom(tilt)).up + tilt * Vector3d::UnitY()).norm(), 1e-6)
      << "the first camera was tilted";

  CompactMap turned = turnedRoom(Eigen::AngleAxisd(-M_PI / 2, Vector3d::UnitX()));
  EXPECT_EQ(frameOfMap(turned).up, Vector3d::UnitZ());
  for (PlanePatch& plane : turned.planes)
    plane.area = 0;
  EXPECT_EQ(frameOfMap(turned).up, -Vector3d::UnitY());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.rotate(Eigen::AngleAxisd(-1.4, Vector3d::UnitX()));
  turned.trajectory.poses = {pose};
  EXPECT_EQ(frameOfMap(turned).up, Vector3d::UnitZ());
}

TEST(MapFrame, AlongFollowsTheLongerWalls)
{
  EXPECT_NEAR(frameOfMap(makeRoomMap()).along.x(), 1, 1e-9);
  for (const double angle : {0.3, 1.2, 2.5}) {
    const Eigen::AngleAxisd turn(angle, Vector3d::UnitY());
    const Vector3d along = frameOfMap(turnedRoom(turn)).along;
    EXPECT_NEAR(std::abs(along.dot(turn * Vector3d::UnitX())), 1, 1e-6) << angle;
  }
}

TEST(MapSection, HasGapsAtDoorsAndWindows)
{
  const CompactMap map = makeRoomMap();
  const auto lengths = [&](std::size_t plane, double level) {
    std::vector<double> found;
    for (const MapLine& line :
         sectionOf(map.planes[plane], plane, -Vector3d::UnitY(), level))
      found.push_back((line.points[1] - line.points[0]).norm());
    std::sort(found.begin(), found.end());
    return found;
  };
  const auto expectLengths = [](const std::vector<double>& found,
                                const std::vector<double>& wanted) {
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], wanted[i], 1e-5);
  };
  expectLengths(lengths(0, 0), {1, 4});
  expectLengths(lengths(0, 1), {6});
  expectLengths(lengths(3, 0.1), {1, 1});
  expectLengths(lengths(1, 0), {4});
  expectLengths(lengths(1, 2), {});
  expectLengths(lengths(4, 0), {});
}

TEST(ScaleBar, LengthsAreRound)
{
  EXPECT_DOUBLE_EQ(roundLength(1), 1);
  EXPECT_DOUBLE_EQ(roundLength(1.99), 1);
  EXPECT_DOUBLE_EQ(roundLength(4.9), 2);
  EXPECT_DOUBLE_EQ(roundLength(73), 50);
  EXPECT_DOUBLE_EQ(roundLength(0.03), 0.02);
  EXPECT_EQ(lengthText(5), "5 m");
  EXPECT_EQ(lengthText(0.2), "20 cm");
  EXPECT_EQ(lengthText(0.005), "5 mm");
  EXPECT_EQ(lengthText(2000), "2 km");
}

} // namespace
} // namespace pcl::acmap::test
