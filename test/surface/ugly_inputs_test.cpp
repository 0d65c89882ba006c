#include "dewall_runs.h"

#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr DeWallRule all_rules[] = {
    DeWallRule::Paper, DeWallRule::Dense, DeWallRule::Strict};

/** Nothing can be made of the cloud: an empty mesh, and the reason said. */
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
  for (const DeWallRule rule : {DeWallRule::Paper, DeWallRule::Dense})
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
  for (const DeWallRule rule : {DeWallRule::Paper, DeWallRule::Dense})
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

TEST(DeWallUgly, twoClustersFarApart)
{
  Cloud cloud = makeJitteredPlane({20, 20, 0.02, 0.25, 0.1, 8}).cloud;
  const std::size_t each =
      triangulate(cloud, {DeWallRule::Paper, 0.06}).report.triangles;
  Eigen::Isometry3d aside = Eigen::Isometry3d::Identity();
  aside.translation().x() = 4096;
  cloud += moved(cloud, aside);
  const DeWallResult result = triangulate(cloud, {DeWallRule::Paper, 0.06});
  EXPECT_TRUE(keepsGuarantees(result, {DeWallRule::Paper, 0.06}));
  EXPECT_EQ(result.report.clusters, 2U);
  EXPECT_NEAR(static_cast<double>(result.report.triangles),
              2.0 * static_cast<double>(each),
              0.02 * static_cast<double>(each));
}

TEST(DeWallUgly, doubledPointsMeshLikeSingleOnes)
{
  const Cloud sheet = makeJitteredPlane({30, 30, 0.02, 0.25, 0.1, 8}).cloud;
  for (const double length : {0.0, 0.06}) {
    const DeWallRun run{DeWallRule::Paper, length};
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
  const DeWallRun run{DeWallRule::Paper, 0.06};
  const DeWallResult result = triangulate(laced, run);
  EXPECT_EQ(result.report.invalid_points, laced.size() - sheet.size());
  EXPECT_EQ(asSets(result.mesh.triangles),
            asSets(triangulate(sheet, run).mesh.triangles, places));
}

} // namespace
} // namespace pcl::acmap::test
