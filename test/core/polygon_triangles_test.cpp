#include "cell_polygons.h"

#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/polygon_triangles.h>
#include <pcl/core/random.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::acmap::test {
namespace {

using Loop = std::vector<Eigen::Vector3f>;

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

std::vector<Eigen::Vector3d>
pointsOf(const PlanePolygon& polygon)
{
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& p : polygon.outer)
    points.push_back(p.cast<double>());
  for (const Loop& hole : polygon.holes)
    for (const Eigen::Vector3f& p : hole)
      points.push_back(p.cast<double>());
  return points;
}

/** Area along the normal; negative for triangles with the wrong orientation. */
double
areaOf(const std::vector<Eigen::Vector3d>& points,
       const TriangleMesh::Triangle& triangle,
       const Eigen::Vector3d& normal)
{
  const auto corner = [&](std::size_t i) {
    return points.at(static_cast<std::size_t>(triangle[i]));
  };
  return 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(normal);
}

double
totalArea(const PlanePolygon& polygon, const Eigen::Vector3d& normal = up)
{
  const auto points = pointsOf(polygon);
  double sum = 0;
  for (const auto& triangle : trianglesOfPolygon(polygon, normal)) {
    const double area = areaOf(points, triangle, normal);
    EXPECT_GT(area, 0);
    sum += area;
  }
  return sum;
}

Loop
rectangle(float x, float y, float width, float height)
{
  return {{x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0}};
}

Loop
turnedBack(Loop loop)
{
  std::reverse(loop.begin(), loop.end());
  return loop;
}

double
loopArea(const Loop& loop)
{
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d a = loop[i].cast<double>();
    const Eigen::Vector3d b = loop[(i + 1) % loop.size()].cast<double>();
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * sum;
}

/** A loop around a centre with a random radius. */
Loop
makeStar(Random& random,
         std::size_t points,
         float x,
         float y,
         double minimum,
         double maximum)
{
  Loop loop;
  for (std::size_t i = 0; i < points; ++i) {
    const double angle =
        2 * M_PI * static_cast<double>(i) / static_cast<double>(points);
    const double radius = minimum + (maximum - minimum) * random.uniform();
    loop.emplace_back(x + static_cast<float>(radius * std::cos(angle)),
                      y + static_cast<float>(radius * std::sin(angle)),
                      0.0F);
  }
  return loop;
}

TEST(PolygonTriangles, SquareAndLAndStar)
{
  EXPECT_EQ(trianglesOfPolygon({rectangle(0, 0, 2, 3), {}}, up).size(), 2u);
  EXPECT_DOUBLE_EQ(totalArea({rectangle(0, 0, 2, 3), {}}), 6);
  const PlanePolygon l{
      {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, {}};
  EXPECT_EQ(trianglesOfPolygon(l, up).size(), 4u);
  EXPECT_DOUBLE_EQ(totalArea(l), 5);
  Random random(3);
  const PlanePolygon star{makeStar(random, 101, 0, 0, 1, 9), {}};
  EXPECT_EQ(trianglesOfPolygon(star, up).size(), 99u);
  EXPECT_NEAR(totalArea(star), loopArea(star.outer), 1e-6);
}

TEST(PolygonTriangles, HolesStayOpenAndIndicesCountThem)
{
  PlanePolygon polygon{rectangle(0, 0, 10, 10), {}};
  for (const float y : {1.0F, 5.0F})
    for (const float x : {1.0F, 4.0F, 7.0F})
      polygon.holes.push_back(turnedBack(rectangle(x, y, 2, 3)));
  const auto triangles = trianglesOfPolygon(polygon, up);
  EXPECT_DOUBLE_EQ(totalArea(polygon), 64);
  std::vector<bool> used(28);
  for (const auto& triangle : triangles)
    for (const std::int32_t corner : triangle)
      used.at(static_cast<std::size_t>(corner)) = true;
  EXPECT_EQ(std::accumulate(used.begin(), used.end(), 0), 28);
}

TEST(PolygonTriangles, EitherWayOfTurningAndAnyNormal)
{
  PlanePolygon polygon{rectangle(0, 0, 4, 4), {rectangle(1, 1, 2, 2)}};
  EXPECT_DOUBLE_EQ(totalArea(polygon), 12);
  polygon.outer = turnedBack(polygon.outer);
  EXPECT_DOUBLE_EQ(totalArea(polygon), 12);
  EXPECT_DOUBLE_EQ(totalArea(polygon, -up), 12);
  const Eigen::Vector3d normal = Eigen::Vector3d(1, -2, 2).normalized();
  const Eigen::Quaterniond turn = smallestRotation(up, normal);
  const auto place = [&](Eigen::Vector3f& p) {
    p = (turn * p.cast<double>() + Eigen::Vector3d(300, -20, 7)).cast<float>();
  };
  for (Eigen::Vector3f& p : polygon.outer)
    place(p);
  for (Eigen::Vector3f& p : polygon.holes[0])
    place(p);
  EXPECT_NEAR(totalArea(polygon, normal), 12, 1e-3);
  EXPECT_NEAR(totalArea(polygon, -5 * normal) / 5, 12, 1e-3);
}

TEST(PolygonTriangles, RepeatedAndCollinearPoints)
{
  const Loop rim{{0, 0, 0},
                 {0, 0, 0},
                 {1, 0, 0},
                 {2, 0, 0},
                 {2, 0, 0},
                 {2, 1, 0},
                 {2, 2, 0},
                 {1, 2, 0},
                 {0, 2, 0},
                 {0, 1, 0},
                 {0, 0, 0}};
  EXPECT_DOUBLE_EQ(totalArea({rim, {}}), 4);
  // A spike inwards and one outwards, each of zero width.
  const Loop spikes{{0, 0, 0},
                    {4, 0, 0},
                    {4, 2, 0},
                    {2, 2, 0},
                    {4, 2, 0},
                    {4, 4, 0},
                    {4, 6, 0},
                    {4, 4, 0},
                    {0, 4, 0}};
  EXPECT_DOUBLE_EQ(totalArea({spikes, {}}), 16);
}

TEST(PolygonTriangles, TouchingHoles)
{
  // A row of diamonds across the polygon: two touch its outline, all touch each other.
  PlanePolygon polygon{rectangle(0, 0, 6, 4), {}};
  for (const float x : {1.0F, 3.0F, 5.0F})
    polygon.holes.push_back({{x - 1, 2, 0}, {x, 3, 0}, {x + 1, 2, 0}, {x, 1, 0}});
  EXPECT_DOUBLE_EQ(totalArea(polygon), 18);
  // Holes at corners of the outline, with a common edge, and one that touches at two
  // points.
  polygon = {rectangle(0, 0, 4, 4),
             {{{0, 0, 0}, {1, 2, 0}, {2, 1, 0}},
              {{2, 2, 0}, {2, 3, 0}, {3, 3, 0}, {3, 2, 0}},
              {{3, 2, 0}, {3, 3, 0}, {4, 4, 0}}}};
  EXPECT_DOUBLE_EQ(totalArea(polygon), 16 - 1.5 - 1 - 0.5);
}

TEST(PolygonTriangles, RegionsOfCellsAreCoveredOnce)
{
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const CellRegion region(seed, 4 + static_cast<int>(seed % 9));
    for (const bool pinched : {false, true})
      for (const auto& [polygon, cells] : region.polygons(pinched)) {
        EXPECT_DOUBLE_EQ(totalArea(polygon), static_cast<double>(cells.size())) << seed;
        EXPECT_EQ(wronglyCovered(polygon, cells, trianglesOfPolygon(polygon, up)), 0)
            << seed << (pinched ? " pinched" : "");
      }
  }
}

/** A loop through lattice points. */
Loop
cornersOf(const std::vector<std::pair<int, int>>& corners)
{
  Loop loop;
  for (const auto& [x, y] : corners)
    loop.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0F);
  return loop;
}

TEST(PolygonTriangles, RimsThatComeBackAlongAnEar)
{
  // Between the two holes and the right part of the outline there is a gap of zero
  // width.
  const PlanePolygon bent{
      cornersOf({{8, 0}, {8, 1}, {7, 1}, {7, 2}, {6, 2}, {6, 4}, {8, 4},
                 {8, 5}, {9, 5}, {9, 8}, {8, 8}, {8, 9}, {5, 9}, {5, 4},
                 {4, 4}, {4, 3}, {5, 3}, {5, 1}, {6, 1}, {6, 0}}),
      {cornersOf({{7, 6}, {8, 6}, {8, 5}, {7, 5}}),
       cornersOf({{8, 7}, {7, 7}, {7, 8}, {8, 8}})}};
  EXPECT_DOUBLE_EQ(totalArea(bent), 23);
  // Two holes are bridged to the start point of the outline.
  const PlanePolygon twice{
      cornersOf({{7, 6},  {7, 5},  {9, 5},  {10, 5}, {10, 4}, {9, 4},
                 {9, 3},  {9, 2},  {10, 2}, {10, 3}, {11, 3}, {11, 4},
                 {11, 7}, {10, 7}, {10, 8}, {11, 8}, {11, 8}, {11, 11},
                 {9, 11}, {8, 11}, {8, 10}, {7, 10}, {7, 6}}),
      {cornersOf({{8, 9}, {9, 9}, {9, 8}, {9, 7}, {8, 7}, {8, 8}}),
       cornersOf({{9, 7}, {10, 7}, {10, 6}, {9, 6}})}};
  EXPECT_DOUBLE_EQ(totalArea(twice), 23);
}

TEST(PolygonTriangles, RandomStarsWithHoles)
{
  Random random(11);
  for (int round = 0; round < 200; ++round) {
    PlanePolygon polygon{makeStar(random, 40, 0, 0, 8, 12), {}};
    double area = loopArea(polygon.outer);
    for (int i = 0; i < 9; ++i) {
      const Loop hole = makeStar(random,
                                 3 + static_cast<std::size_t>(random.uniform() * 20),
                                 static_cast<float>(3 * (i % 3) - 3),
                                 static_cast<float>(3 * (i / 3) - 3),
                                 0.1,
                                 1.4);
      area -= loopArea(hole);
      polygon.holes.push_back(hole);
    }
    EXPECT_NEAR(totalArea(polygon), area, 1e-5 * area) << round;
  }
}

TEST(PolygonTriangles, CombAndSpiralAreQuick)
{
  Loop comb;
  for (int tooth = 0; tooth < 1000; ++tooth) {
    comb.emplace_back(static_cast<float>(tooth), 100.0F, 0.0F);
    comb.emplace_back(static_cast<float>(tooth) + 0.5F, 1.0F, 0.0F);
  }
  comb.emplace_back(1000.0F, 0.0F, 0.0F);
  comb.emplace_back(0.0F, 0.0F, 0.0F);
  Loop spiral;
  for (int i = 0; i < 5000; ++i) {
    const double angle = 0.02 * i;
    const double radius = 1 + angle;
    spiral.emplace_back(static_cast<float>(radius * std::cos(angle)),
                        static_cast<float>(radius * std::sin(angle)),
                        0.0F);
  }
  for (int i = 4999; i >= 0; --i)
    spiral.emplace_back(spiral[static_cast<std::size_t>(i)] * 1.01F);
  for (const Loop& loop : {comb, spiral}) {
    const auto begin = std::chrono::steady_clock::now();
    const double area = totalArea({loop, {}});
    EXPECT_NEAR(area, std::abs(loopArea(loop)), 1e-5 * area);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
  }
}

TEST(PolygonTriangles, DegenerateOnesAreEmpty)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Loop& loop : {Loop{},
                           Loop{{1, 1, 0}},
                           Loop{{1, 1, 0}, {2, 2, 0}},
                           Loop{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {5, 5, 0}},
                           Loop(50, Eigen::Vector3f(3, 3, 0)),
                           Loop{{nan, 0, 0}, {1, 1, 0}, {2, nan, 0}, {0, 3, 0}}})
    EXPECT_TRUE(trianglesOfPolygon({loop, {}}, up).empty());
  EXPECT_DOUBLE_EQ(totalArea({{{0, 0, 0}, {nan, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {}}), 2);
  const PlanePolygon needle{rectangle(0, 0, 1, 1),
                            {{{0.2F, 0.2F, 0}, {0.6F, 0.6F, 0}}}};
  EXPECT_DOUBLE_EQ(totalArea(needle), 1);
  EXPECT_THROW(trianglesOfPolygon(needle, Eigen::Vector3d::Zero()),
               BadArgumentException);
  EXPECT_THROW(trianglesOfPolygon(needle, Eigen::Vector3d(nan, 0, 1)),
               BadArgumentException);
}

/** Number of positions of a grid over 0 to 20 that are covered more than once, or are
 * covered although they are outside the outline or in a hole. */
int
badlyCovered(const PlanePolygon& polygon, const TriangleMesh::Triangles& triangles)
{
  const auto windings = [](const Loop& loop, double x, double y) {
    int count = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Eigen::Vector3d a = loop[i].cast<double>();
      const Eigen::Vector3d b = loop[(i + 1) % loop.size()].cast<double>();
      if ((a.y() > y) != (b.y() > y) &&
          a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()) > x)
        count += b.y() > a.y() ? 1 : -1;
    }
    return loopArea(loop) > 0 ? count : loopArea(loop) < 0 ? -count : 0;
  };
  const std::vector<Eigen::Vector3f> points = pointsOfPolygon(polygon);
  int bad = 0;
  for (double x = 0.137; x < 20; x += 0.53)
    for (double y = 0.171; y < 20; y += 0.53) {
      int inside = windings(polygon.outer, x, y);
      for (const Loop& hole : polygon.holes)
        inside -= windings(hole, x, y);
      int cover = 0;
      for (const auto& [a, b, c] : triangles)
        cover += windings({points[static_cast<std::size_t>(a)],
                           points[static_cast<std::size_t>(b)],
                           points[static_cast<std::size_t>(c)]},
                          x,
                          y);
      bad += cover > (inside > 0 ? 1 : 0);
    }
  return bad;
}

TEST(PolygonTriangles, CrossingRimsLackTriangles)
{
  // The tip of an outline crosses its other side, and a hole crosses the outline.
  const PlanePolygon poked{
      cornersOf({{0, 0}, {20, 0}, {20, 10}, {11, 10}, {10, -1}, {9, 10}, {0, 10}}), {}};
  const PlanePolygon left{cornersOf({{0, 0}, {10, 0}, {10, 10}, {0, 10}}),
                          {cornersOf({{5, 5}, {5, 7}, {15, 6}})}};
  // Two parts with opposite orientation that meet in a corner.
  const PlanePolygon eight{
      cornersOf({{0, 0}, {8, 0}, {10, 5}, {12, 9}, {16, 9}, {16, 1}, {10, 5}, {0, 9}}),
      {}};
  for (const PlanePolygon& polygon : {poked, left, eight}) {
    EXPECT_EQ(badlyCovered(polygon, trianglesOfPolygon(polygon, up)), 0);
    EXPECT_GT(totalArea(polygon), 0);
  }
}

TEST(PolygonTriangles, CrossingRimsEnd)
{
  Random random(5);
  for (int round = 0; round < 100; ++round) {
    PlanePolygon polygon;
    for (std::size_t loop = 0; loop < 4; ++loop) {
      Loop points;
      for (int i = 0; i < 5 * (round % 20) + 3; ++i)
        points.emplace_back(static_cast<float>(std::floor(20 * random.uniform())),
                            static_cast<float>(std::floor(20 * random.uniform())),
                            0.0F);
      if (loop == 0)
        polygon.outer = points;
      else
        polygon.holes.push_back(points);
    }
    const auto points = pointsOf(polygon);
    const auto triangles = trianglesOfPolygon(polygon, up);
    EXPECT_LE(triangles.size(), points.size() + 4);
    EXPECT_EQ(badlyCovered(polygon, triangles), 0) << round;
    for (const auto& triangle : triangles)
      EXPECT_GT(areaOf(points, triangle, up), 0);
  }
}

TEST(PolygonTriangles, LargeAndSmallNumbers)
{
  for (const float size : {1e-20F, 1e-3F, 1e6F, 1e18F}) {
    const PlanePolygon polygon{rectangle(0, 0, size, 2 * size), {}};
    EXPECT_NEAR(totalArea(polygon) / (2.0 * size * size), 1, 1e-6);
  }
}

} // namespace
} // namespace pcl::acmap::test
