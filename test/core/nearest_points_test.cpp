#include "cylinders/nearest_points.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

using Points = LargeVector<Eigen::Vector3d>;

std::vector<std::int32_t>
nearestByComparison(const Points& points,
                    const Eigen::Vector3d& place,
                    std::size_t count)
{
  std::vector<std::pair<double, std::int32_t>> all;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      all.emplace_back((points[i] - place).squaredNorm(), static_cast<std::int32_t>(i));
  std::sort(all.begin(), all.end());
  std::vector<std::int32_t> nearest;
  for (std::size_t k = 0; k < std::min(count, all.size()); ++k)
    nearest.push_back(all[k].second);
  return nearest;
}

/** Points on a coarse lattice, so that many distances are equal. */
Points
latticePoints(std::size_t size)
{
  Random random(7);
  const auto coordinate = [&] { return std::floor(random.uniform(0, 6)); };
  Points points;
  for (std::size_t i = 0; i < size; ++i) {
    const double x = coordinate(), y = coordinate();
    points.emplace_back(x, y, coordinate());
  }
  return points;
}

TEST(NearestPoints, areThoseOfBruteForceAlsoWithEqualDistances)
{
  for (const std::size_t size : {0, 1, 12, 13, 300, 2000}) {
    Points points = latticePoints(size);
    if (size > 100)
      points[50].y() = std::numeric_limits<double>::quiet_NaN();
    const cylinders::NearestPoints tree(points);
    std::vector<std::int32_t> found;
    for (const std::size_t count : {0, 1, 13, 41})
      for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 100) {
        tree.find(points[i], count, found);
        if (points[i].allFinite())
          EXPECT_EQ(found, nearestByComparison(points, points[i], count));
        else
          EXPECT_TRUE(found.empty());
      }
  }
}

TEST(NearestPoints, areTheSameForAllNumbersOfThreads)
{
  Random random(9);
  Points points;
  for (std::size_t i = 0; i < 50000; ++i) {
    const double x = random.uniform(0, 1), y = random.uniform(0, 1);
    points.emplace_back(x, y, random.uniform(0, 1));
  }
  for (const unsigned threads : {1, 4})
    withThreads(threads, [&] {
      const cylinders::NearestPoints tree(points);
      std::vector<std::int32_t> found;
      for (std::size_t i = 0; i < points.size(); i += 5000) {
        tree.find(points[i], 13, found);
        EXPECT_EQ(found, nearestByComparison(points, points[i], 13));
      }
    });
}

} // namespace
} // namespace pcl::acmap::test
