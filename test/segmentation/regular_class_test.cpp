#include "clustering_runs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

void
setRegular(Clustering& clustering)
{
  clustering.setRegularize(true);
}

Eigen::Vector3d
normalOf(const PlanePatch& patch)
{
  return patch.coefficients.head<3>();
}

/** A floor, and a wall that leans by this angle in radians. */
VotingMesh
makeLeaningWall(double lean)
{
  const VotingMesh wall = makeSheetMesh(41, 31, grid, [=](double u, double v) {
    const double up = v + 0.8;
    return Eigen::Vector3d(u, 2.2 + up * std::sin(lean), up * std::cos(lean));
  });
  return withNoise(together(makeWall(4, 4), wall), {0, 1, 1}, 0.002);
}

TEST(RegularClustering, wallsOfARoomAreAtRightAngles)
{
  const VotingMesh mesh = withNoise(makeCornerMesh(), {1, 1, 1}, 0.002);
  const Clustered plain = clusterOn(mesh);
  const Clustered regular = clusterOn(mesh, setRegular);
  ASSERT_EQ(plain.patches.size(), 3U);
  ASSERT_EQ(regular.patches.size(), 3U);
  EXPECT_EQ(plain.report.regular_planes, 0U) << "only where it is asked for";
  EXPECT_EQ(regular.report.regular_planes, 2U) << "after the largest";
  EXPECT_GT(regular.report.largest_turn, 0);
  EXPECT_LT(regular.report.largest_turn, 1 * degree);
  double before = 0;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      before += std::abs(normalOf(plain.patches[a]).dot(normalOf(plain.patches[b])));
      EXPECT_NEAR(
          normalOf(regular.patches[a]).dot(normalOf(regular.patches[b])), 0, 1e-9);
    }
  EXPECT_GT(before, 1e-6);
}

TEST(RegularClustering, boardsAreParallelAndStayWhereTheyAre)
{
  const VotingMesh mesh = withNoise(makeBoards(0.5), {0, 0, 1}, 0.003);
  const Clustered plain = clusterOn(mesh);
  const Clustered regular = clusterOn(mesh, setRegular);
  ASSERT_EQ(regular.patches.size(), 2U);
  EXPECT_NEAR(normalOf(regular.patches[0]).dot(normalOf(regular.patches[1])), 1, 1e-12);
  for (std::size_t p = 0; p < 2; ++p) {
    const PlanePatch& patch = regular.patches[p];
    EXPECT_LT((patch.center - plain.patches[p].center).norm(), 1e-9)
        << "they turn about their centres";
    EXPECT_NEAR(distanceFrom(patch, patch.center), 0, 1e-9);
    EXPECT_LT((patch.axis_u.cross(patch.axis_v) - normalOf(patch)).norm(), 1e-9);
    for (const Eigen::Vector3f& vertex : patch.polygons[0].outer)
      EXPECT_NEAR(distanceFrom(patch, vertex.cast<double>()), 0, 1e-5);
  }
}

/** If a wall leans by more than its uncertainty, it is not corrected. */
TEST(RegularClustering, leaningWallsStayLeaning)
{
  for (const double lean : {2 * degree, 5 * degree, 20 * degree}) {
    const Clustered found = clusterOn(makeLeaningWall(lean), setRegular);
    ASSERT_EQ(found.patches.size(), 2U);
    EXPECT_EQ(found.report.regular_planes, 0U);
    EXPECT_NEAR(
        std::asin(std::abs(normalOf(found.patches[0]).dot(normalOf(found.patches[1])))),
        lean,
        0.3 * degree);
  }
  EXPECT_EQ(clusterOn(makeLeaningWall(0), setRegular).report.regular_planes, 1U);
}

} // namespace
} // namespace pcl::acmap::test
