#include "dewall_runs.h"

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr DeWallRule all_rules[] = {
    DeWallRule::Guarded, DeWallRule::Dense, DeWallRule::Strict};

/** Expects an empty mesh and a remark that says why. */
void
expectEmptyWithReason(const Cloud& cloud)
{
  for (const DeWallRule rule : all_rules)
    for (const double length : {0.0, 1.5}) {
      const DeWallResult result = triangulate(cloud, {rule, length});
      EXPECT_TRUE(result.mesh.triangles.empty());
      EXPECT_FALSE(result.report.remarks.empty())
          << nameOf(rule) << ", length " << length;
      EXPECT_EQ(result.report.points, cloud.size());
    }
}

TEST(DeWallUgly, nothingToMesh)
{
  expectEmptyWithReason({});
  expectEmptyWithReason(makeRandomBox(1, 1));
  expectEmptyWithReason(makeRandomBox(2, 1));
  expectEmptyWithReason(doubled(makeRandomBox(2, 1)));
}

TEST(DeWallUgly, collinearPoints)
{
  expectEmptyWithReason(makeCollinear(3));
  expectEmptyWithReason(makeCollinear(500));
}

TEST(DeWallUgly, nearlyCollinearPointsKeepTheGuarantees)
{
  Cloud line;
  for (int i = 0; i < 300; ++i)
    line.push_back({0.1F * static_cast<float>(i), 0.3F * static_cast<float>(i), 0.7F});
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense})
    for (const double length : {0.0, 1.5})
      EXPECT_TRUE(keepsGuarantees(triangulate(line, {rule, length}), {rule, length}));
}

TEST(DeWallUgly, coincidentPoints)
{
  const Cloud cloud = makeCoincident(65000);
  expectEmptyWithReason(cloud);
  EXPECT_EQ(triangulate(cloud, {}).report.duplicate_points, 64999U);
}

TEST(DeWallUgly, allInvalid)
{
  Cloud cloud = makeCoincident(1000);
  for (PointXYZ& point : cloud)
    point.y = std::numeric_limits<float>::quiet_NaN();
  expectEmptyWithReason(cloud);
  EXPECT_EQ(triangulate(cloud, {}).report.invalid_points, 1000U);
}

/** Fewer points than needed to estimate the spacing, and distances beyond the range of
 * float: the neighbour search returns infinity. */
TEST(DeWallUgly, fewPointsHaveNoNeighboursButEachOther)
{
  for (const float far : {0.0F, 4096.0F}) {
    const Cloud square = makeGrid(2, 2, 0.25, ExactPlane::Level);
    const DeWallResult result = triangulate(
        moved(square, Eigen::Isometry3d(Eigen::Translation3d(far, far, far))), {});
    EXPECT_EQ(result.mesh.triangles.size(), 2U);
    EXPECT_FLOAT_EQ(result.report.largest_maximum_edge, 2.5F * 0.25F * std::sqrt(2.0F));
  }
  Cloud huge;
  for (const float far : {0.0F, 3e38F, -3e38F})
    huge.push_back({far, std::abs(far), 1});
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense})
    EXPECT_TRUE(keepsGuarantees(triangulate(huge, {rule}), {rule})) << nameOf(rule);
}

TEST(DeWallUgly, unitsBeyondAllReasonKeepTheGuarantees)
{
  const Cloud sheet = makeJitteredPlane({10, 10, 1, 0.25, 0.2, 8}).cloud;
  const DeWallRun run{DeWallRule::Guarded, 0};
  const std::size_t triangles = triangulate(sheet, run).mesh.triangles.size();
  for (const float factor : {1e-30F, 1e-20F, 1e20F, 1e30F}) {
    const DeWallResult result = triangulate(scaled(sheet, factor), run);
    EXPECT_TRUE(keepsGuarantees(result, run)) << factor;
    EXPECT_NEAR(static_cast<double>(result.mesh.triangles.size()),
                static_cast<double>(triangles),
                2)
        << factor;
  }
}

/** The distance of the third vertex from the longest edge is below the rounding error
 * of a subtraction: it must not be found again beyond that edge. */
TEST(DeWallUgly, needlesAreBuiltOnce)
{
  for (const float far : {1e6F, 1e9F}) {
    Cloud needle;
    needle.push_back({83, 116, 0});
    needle.push_back({121, -far, 0});
    needle.push_back({87, 87, 0});
    for (const DeWallRule rule : all_rules) {
      const DeWallResult result = triangulate(needle, {rule});
      EXPECT_EQ(result.mesh.triangles.size(), 1U) << nameOf(rule) << ", " << far;
      EXPECT_TRUE(keepsGuarantees(result, {rule})) << nameOf(rule) << ", " << far;
    }
  }
}

TEST(DeWallUgly, spheresMayLeaveTheFloats)
{
  const float near = 1e35F, maximum = std::numeric_limits<float>::max();
  Cloud cloud;
  cloud.push_back({1.00005996F * near, 1.00007976F * near, 0});
  cloud.push_back({maximum, 1.00007204F * near, 0});
  cloud.push_back({0, 1.00007016F * near, 0}); // its sphere with the two others has a
                                               // radius of 2e43 m
  cloud.push_back({-maximum, -maximum, 0});    // inside that sphere, by 3e38 m
  const DeWallResult result = triangulate(cloud, {DeWallRule::Guarded});
  MeshDemands demands;
  demands.empty_spheres = true;
  demands.sphere_tolerance = 1e-5;
  EXPECT_EQ(checkMesh(result.points, result.mesh.triangles, demands).total(), 0U);
}

TEST(DeWallUgly, oneTriangle)
{
  const Cloud three = makeRandomBox(3, 1);
  for (const DeWallRule rule : all_rules) {
    EXPECT_EQ(triangulate(three, {rule, 2}).mesh.triangles.size(), 1U) << nameOf(rule);
    EXPECT_TRUE(triangulate(three, {rule, 0.01}).mesh.triangles.empty());
  }
}

TEST(DeWallUgly, outlierDoesNotHarmTheRest)
{
  const Cloud sheet = makeJitteredPlane({30, 30, 0.02, 0.25, 0.1, 8}).cloud;
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense})
    for (const double length : {0.0, 0.06}) {
      const auto clean = triangulate(sheet, {rule, length}).mesh.triangles.size();
      for (const float place : {1e9F, -1e9F, 3e38F}) {
        const DeWallRun run{rule, length};
        const DeWallResult result = triangulate(withOutlier(sheet, place), run);
        EXPECT_TRUE(keepsGuarantees(result, run));
        EXPECT_NEAR(static_cast<double>(result.mesh.triangles.size()),
                    static_cast<double>(clean),
                    0.01 * static_cast<double>(clean));
      }
    }
}

TEST(DeWallUgly, squaresOfDistancesMayOverflow)
{
  // Sizes for which the tree's last group of cells is full, and others.
  for (const std::size_t size : {20, 90, 120, 300, 900}) {
    const Cloud cloud = withOutlier(makeRandomBox(size, 17), 3e38F);
    for (const double length : {0.0, 0.5})
      EXPECT_TRUE(keepsGuarantees(triangulate(cloud, {DeWallRule::Guarded, length}),
                                  {DeWallRule::Guarded, length}))
          << size << " points, length " << length;
  }
}

TEST(DeWallUgly, moreTiesThanTheSearchHasRoomFor)
{
  const Cloud circle = makeExactCircle(1105, false);
  ASSERT_EQ(circle.size(), 108U);
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense}) {
    const DeWallRun run{rule, 3000};
    const DeWallResult result = triangulate(circle, run);
    EXPECT_TRUE(keepsGuarantees(result, run));
    EXPECT_EQ(result.mesh.triangles.size(), circle.size() - 2) << nameOf(rule);
  }
}

TEST(DeWallUgly, twoClustersFarApart)
{
  Cloud cloud = makeJitteredPlane({20, 20, 0.02, 0.25, 0.1, 8}).cloud;
  const std::size_t each =
      triangulate(cloud, {DeWallRule::Guarded, 0.06}).report.triangles;
  Eigen::Isometry3d aside = Eigen::Isometry3d::Identity();
  aside.translation().x() = 4096;
  cloud += moved(cloud, aside);
  const DeWallResult result = triangulate(cloud, {DeWallRule::Guarded, 0.06});
  EXPECT_TRUE(keepsGuarantees(result, {DeWallRule::Guarded, 0.06}));
  EXPECT_EQ(result.report.clusters, 2U);
  cloud.emplace_back(-10.0F, 0.0F, 0.0F);
  cloud.emplace_back(-10.0F, 0.01F, 0.0F);
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Strict})
    EXPECT_EQ(triangulate(cloud, {rule, 0.06}).report.clusters, 2U)
        << "two points are none";
  EXPECT_NEAR(static_cast<double>(result.report.triangles),
              2.0 * static_cast<double>(each),
              0.02 * static_cast<double>(each));
}

TEST(DeWallUgly, doubledPointsMeshLikeSingleOnes)
{
  const Cloud sheet = makeJitteredPlane({30, 30, 0.02, 0.25, 0.1, 8}).cloud;
  for (const double length : {0.0, 0.06}) {
    const DeWallRun run{DeWallRule::Guarded, length};
    const DeWallResult twice = triangulate(doubled(sheet), run);
    EXPECT_EQ(twice.report.duplicate_points, sheet.size());
    EXPECT_EQ(asSets(twice.mesh.triangles),
              asSets(triangulate(sheet, run).mesh.triangles));
  }
}

TEST(DeWallUgly, invalidPointsMeshLikeAbsentOnes)
{
  const Cloud sheet = makeJitteredPlane({30, 30, 0.02, 0.25, 0.1, 8}).cloud;
  const Cloud laced = lacedWithNan(sheet, 3);
  std::vector<std::int32_t> places;
  for (std::size_t i = 0; i < laced.size(); ++i)
    if (laced[i].getVector3fMap().allFinite())
      places.push_back(static_cast<std::int32_t>(i));
  const DeWallRun run{DeWallRule::Guarded, 0.06};
  const DeWallResult result = triangulate(laced, run);
  EXPECT_EQ(result.report.invalid_points, laced.size() - sheet.size());
  EXPECT_EQ(asSets(result.mesh.triangles),
            asSets(triangulate(sheet, run).mesh.triangles, places));
}

} // namespace
} // namespace pcl::acmap::test
