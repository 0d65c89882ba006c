#include "clustering_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr double noise = 0.0003; // metres, much less than the warp of the walls

/** A sheet of this length and 2.5 m height, with given distances from z = 0 and
 * noise. */
VotingMesh
makeSheet(double length, const std::function<double(double, double)>& height)
{
  const int columns = static_cast<int>(length / grid) + 1, rows = 51;
  return withNoise(makeSheetMesh(columns,
                                 rows,
                                 grid,
                                 [&](double u, double v) {
                                   return Eigen::Vector3d(u, v, height(u, v));
                                 }),
                   {0, 0, 1},
                   noise);
}

double
shareOf(const Clustered& found, std::int32_t plane)
{
  return static_cast<double>(
             std::count(found.labels.begin(), found.labels.end(), plane)) /
         static_cast<double>(found.labels.size());
}

TEST(WarpedPlanes, wavyWallIsOnePlane)
{
  for (const double height : {0.004, 0.008, 0.012}) {
    const Clustered found = clusterOn(makeSheet(4, [&](double u, double v) {
      return height * std::sin(4 * u) * std::cos(3 * v);
    }));
    ASSERT_EQ(found.patches.size(), 1U) << height;
    EXPECT_GT(shareOf(found, 0), 0.97) << height;
    EXPECT_LT(angleFrom(found.patches[0], Eigen::Vector3d::UnitZ()), 0.002) << height;
    EXPECT_EQ(found.report.points_on_curved, 0U) << height;
  }
}

TEST(WarpedPlanes, longFloorThatSagsIsOnePlane)
{
  const Clustered found = clusterOn(
      makeSheet(20, [](double u, double) { return 0.015 * std::cos(M_PI * u / 10); }));
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_GT(shareOf(found, 0), 0.97);
}

TEST(WarpedPlanes, stepIsNotTakenForASag)
{
  const Clustered found =
      clusterOn(makeSheet(20, [](double u, double) { return u < 0 ? 0.0 : 0.03; }));
  ASSERT_EQ(found.patches.size(), 2U);
  EXPECT_GT(shareOf(found, 0), 0.48);
  EXPECT_GT(shareOf(found, 1), 0.48);
}

TEST(WarpedPlanes, rampIsNotPartOfTheFloor)
{
  const Clustered found = clusterOn(
      makeSheet(12, [](double u, double) { return std::max(0.0, 0.05 * u); }));
  ASSERT_EQ(found.patches.size(), 2U);
  for (const PlanePatch& patch : found.patches)
    EXPECT_LT(std::min(angleFrom(patch, Eigen::Vector3d::UnitZ()),
                       angleFrom(patch, Eigen::Vector3d(-0.05, 0, 1).normalized())),
              0.004);
}

TEST(WarpedPlanes, gentleCylinderStaysCurvedHoweverWideTheBand)
{
  for (const double radius : {5.0, 8.0, 12.0, 20.0}) {
    const Clustered found = clusterOn(makeCurvedWall(radius, noise));
    EXPECT_TRUE(found.patches.empty()) << radius;
    EXPECT_GT(found.report.points_on_curved, 0U) << radius;
  }
}

} // namespace
} // namespace pcl::acmap::test
