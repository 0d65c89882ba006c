#include "planes/unreached_points.h"
#include "random_points.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace pcl::acmap::test {
namespace {

using Points = LargeVector<Eigen::Vector3d>;

/** Reaches, restores and removes at random, beside a search through all points. */
void
compareWithAllPoints(const Points& points, double radius)
{
  planes::UnreachedPoints unreached(points, radius);
  std::set<std::int32_t> removed, reached;
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    const auto kind = static_cast<std::int32_t>(random.uniform(0, 3));
    const auto qualifies = [&](std::int32_t j) { return j % 3 != kind; };
    for (int step = 0; step < 30; ++step) {
      const auto i = static_cast<std::int32_t>(
          random.uniform(0, static_cast<double>(points.size())));
      const Eigen::Vector3d& place = points[static_cast<std::size_t>(i)];
      if (!place.allFinite() || removed.count(i) > 0)
        continue;
      if (reached.insert(i).second && qualifies(i))
        unreached.reach(i);
      std::vector<std::int32_t> wanted, found;
      for (std::size_t k = 0; k < points.size(); ++k)
        if (const auto j = static_cast<std::int32_t>(k);
            qualifies(j) && removed.count(j) + reached.count(j) == 0 &&
            (points[k] - place).squaredNorm() < radius * radius)
          wanted.push_back(j);
      unreached.reachNear(i, qualifies, [&](std::int32_t j) { found.push_back(j); });
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, wanted);
      reached.insert(found.begin(), found.end());
    }
    unreached.restore();
    std::vector<std::int32_t> gone;
    for (const std::int32_t i : reached)
      if (i % 4 == 0)
        gone.push_back(i);
    for (const std::int32_t i : gone) {
      unreached.remove(i);
      removed.insert(i);
    }
    reached.clear();
  }
}

TEST(UnreachedPoints, AreFoundOnce)
{
  for (const double radius : {0.05, 0.3, 1.0, 10.0})
    compareWithAllPoints(makePoints(600, 1, Eigen::Vector3d::Zero(), 7), radius);
  compareWithAllPoints(makePoints(600, 1, {-70, 30, 1e5}, 7), 0.25);
}

TEST(UnreachedPoints, UglyOnesAreFoundNeverOrOnce)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Points points = makePoints(300, 1, Eigen::Vector3d::Zero(), 7);
  for (std::size_t i = 0; i < points.size(); i += 7)
    points[i] = points[0];
  for (std::size_t i = 3; i < points.size(); i += 11)
    points[i] = {nan, 0, 0};
  points[5] = {1e300, -1e300, 1e300};
  points[6] = points[5];
  compareWithAllPoints(points, 0.4);
  const Points none;
  planes::UnreachedPoints(none, 1).restore();
}

} // namespace
} // namespace pcl::acmap::test
