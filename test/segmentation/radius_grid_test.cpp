#include "planes/radius_grid.h"
#include "random_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pcl::acmap::test {
namespace {

using Points = LargeVector<Eigen::Vector3d>;

std::vector<std::int32_t>
nearInGrid(const planes::RadiusGrid& grid, const Eigen::Vector3d& place)
{
  std::vector<std::int32_t> near;
  grid.visitNear(place, [&](std::int32_t point) { near.push_back(point); });
  std::sort(near.begin(), near.end());
  return near;
}

void
compareWithBruteForce(const Points& points, double radius)
{
  const planes::RadiusGrid grid(points, radius);
  for (const Eigen::Vector3d& place : points) {
    if (!place.allFinite())
      continue;
    std::vector<std::int32_t> wanted;
    for (std::size_t j = 0; j < points.size(); ++j)
      if ((points[j] - place).squaredNorm() < radius * radius)
        wanted.push_back(static_cast<std::int32_t>(j));
    ASSERT_EQ(nearInGrid(grid, place), wanted);
  }
}

TEST(RadiusGrid, findsAllThatAreNearer)
{
  for (const double radius : {0.05, 0.3, 1.0, 10.0})
    compareWithBruteForce(makePoints(600, 1, Eigen::Vector3d::Zero(), 5), radius);
  compareWithBruteForce(makePoints(600, 1, {-70, 30, 1e5}, 5), 0.25);
}

/** Points on the borders of the cubes, on both sides of 0. */
TEST(RadiusGrid, bordersAreNoBorders)
{
  Points points;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z)
        points.emplace_back(0.5 * x, 0.5 * y, 0.5 * z);
  for (const double radius : {0.5, 0.50001, 1.0, 0.25})
    compareWithBruteForce(points, radius);
}

TEST(RadiusGrid, uglyPointsAreInNone)
{
  Points points = makePoints(300, 1, Eigen::Vector3d::Zero(), 5);
  points[7].x() = std::numeric_limits<double>::quiet_NaN();
  points[70].y() = std::numeric_limits<double>::infinity();
  points[90] = Eigen::Vector3d(1e30, -1e30, 1e300);
  points[91] = points[92];
  compareWithBruteForce(points, 0.4);
  const planes::RadiusGrid empty(Points(), 1);
  EXPECT_TRUE(nearInGrid(empty, Eigen::Vector3d::Zero()).empty());
}

} // namespace
} // namespace pcl::acmap::test
