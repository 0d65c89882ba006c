#include <pcl/core/impl/nearest_points.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace pcl::acmap::test {
namespace {

using SearchedPoints = LargeVector<Eigen::Vector3d>;

/** The distances of the nearest points, by comparison with all. */
std::vector<double>
nearestDistances(const SearchedPoints& points,
                 const Eigen::Vector3d& place,
                 std::size_t count)
{
  std::vector<double> all;
  for (const Eigen::Vector3d& point : points)
    if (point.allFinite())
      all.push_back((point - place).norm());
  std::sort(all.begin(), all.end());
  all.resize(std::min(count, all.size()));
  return all;
}

/** Points that are found have the right distances, and none is found twice. */
void
expectNearest(const NearestPoints& tree,
              const SearchedPoints& points,
              const Eigen::Vector3d& place,
              std::size_t count)
{
  Indices found;
  tree.find(place.cast<float>(), count, found);
  const std::vector<double> wanted = nearestDistances(points, place, count);
  ASSERT_EQ(found.size(), wanted.size());
  EXPECT_EQ(std::set<index_t>(found.begin(), found.end()).size(), found.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR((points[static_cast<std::size_t>(found[k])] - place).norm(),
                wanted[k],
                1e-6 * (1 + place.norm()));
}

/** Points on a coarse lattice, so that many distances are equal. */
SearchedPoints
latticePoints(std::size_t size)
{
  Random random(7);
  const auto coordinate = [&] { return std::floor(random.uniform(0, 6)); };
  SearchedPoints points;
  for (std::size_t i = 0; i < size; ++i) {
    const double x = coordinate(), y = coordinate();
    points.emplace_back(x, y, coordinate());
  }
  return points;
}

TEST(NearestPoints, areThoseOfBruteForceAlsoWithEqualDistances)
{
  for (const std::size_t size : {0, 1, 12, 13, 300, 2000}) {
    SearchedPoints points = latticePoints(size);
    if (size > 100)
      points[50].y() = std::numeric_limits<double>::quiet_NaN();
    const NearestPoints tree(points);
    for (const std::size_t count : {0, 1, 13, 41})
      for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 100)
        if (points[i].allFinite())
          expectNearest(tree, points, points[i], count);
  }
}

TEST(NearestPoints, ofNothingAndOfNowhereAreNone)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr float inf = std::numeric_limits<float>::infinity();
  const NearestPoints none{SearchedPoints()}, invalid(SearchedPoints(20, {nan, 0, 0})),
      far(SearchedPoints(20, {1e300, 0, 0})), some(latticePoints(20));
  Indices found{7};
  for (const NearestPoints* tree : {&none, &invalid, &far}) {
    tree->find({0, 0, 0}, 3, found);
    EXPECT_TRUE(found.empty());
  }
  SearchedPoints wide = latticePoints(300); // FLANN aborts of what is left out here
  for (std::size_t i = 0; i < wide.size(); i += 3)
    wide[i] *= static_cast<double>(std::numeric_limits<float>::max()) / 8;
  const NearestPoints near(wide);
  near.find(wide[1].cast<float>(), wide.size(), found);
  EXPECT_GE(found.size(), wide.size() * 2 / 3);
  for (const index_t i : found)
    EXPECT_LT(wide[static_cast<std::size_t>(i)].norm(), 20);
  found = {7};
  some.find({inf, 0, 0}, 3, found);
  EXPECT_TRUE(found.empty());
}

TEST(NearestPoints, areTheSameForAllNumbersOfThreads)
{
  Random random(9);
  SearchedPoints points;
  for (std::size_t i = 0; i < 50000; ++i) {
    const double x = random.uniform(0, 1), y = random.uniform(0, 1);
    points.emplace_back(x, y, random.uniform(0, 1));
  }
  std::vector<std::vector<Indices>> runs;
  for (const unsigned threads : {1, 4})
    withThreads(threads, [&] {
      const NearestPoints tree(points);
      std::vector<Indices> found(points.size() / 50);
      parallelForChunks(found.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          tree.find(points[50 * i].cast<float>(), 13, found[i]);
      });
      runs.push_back(std::move(found));
      for (std::size_t i = 0; i < points.size(); i += 5000)
        expectNearest(tree, points, points[i], 13);
    });
  EXPECT_EQ(runs[0], runs[1]);
}

} // namespace
} // namespace pcl::acmap::test
