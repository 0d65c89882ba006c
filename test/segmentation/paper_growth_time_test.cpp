#include <pcl/core/random.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** Points on squares of 0.4 m, which are far from each other. */
std::vector<Eigen::Vector3f>
boardsOf(std::size_t points, std::size_t boards)
{
  Random random(1);
  std::vector<Eigen::Vector3f> all;
  for (std::size_t i = 0; i < points; ++i)
    all.emplace_back(static_cast<float>(5 * (i % boards) + random.uniform(0, 0.4)),
                     static_cast<float>(random.uniform(0, 0.4)),
                     0.0F);
  return all;
}

double
secondsOf(const std::vector<Eigen::Vector3f>& points)
{
  const PointView view(points.data(), sizeof points[0], points.size());
  return secondsOfPaperGrowth(view, 0.8);
}

TEST(PaperGrowthTime, GrowsWithThePairsOfPointsWithinReach)
{
  const double few = secondsOf(boardsOf(2000, 1));
  EXPECT_GT(few, 0);
  EXPECT_LT(few, 10);
  EXPECT_NEAR(secondsOf(boardsOf(8000, 1)), 16 * few, 0.2 * few);
  EXPECT_NEAR(secondsOf(boardsOf(8000, 4)), 4 * few, 0.2 * few);
  EXPECT_GT(secondsOf(boardsOf(200000, 1)), 60) << "of what takes minutes is warned";
  EXPECT_EQ(secondsOf({}), 0);
}

} // namespace
} // namespace pcl::acmap::test
