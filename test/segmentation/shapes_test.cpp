#include "closed_meshes.h"
#include "clustering_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

void
expectNoPlane(const VotingMesh& mesh)
{
  const Clustered found = clusterOn(mesh);
  EXPECT_EQ(found.patches.size(), 0U);
  EXPECT_EQ(found.report.planes, 0U);
  EXPECT_EQ(leftOut(found), mesh.cloud.size());
  EXPECT_GT(found.report.curved_regions, 0U);
  EXPECT_GT(found.report.points_on_curved, 8 * mesh.cloud.size() / 10);
  ASSERT_FALSE(found.report.remarks.empty());
  EXPECT_NE(found.report.remarks.back().find("curved"), std::string::npos);
}

TEST(PlaneShapes, flatGridIsExact)
{
  const VotingMesh mesh = makeWall(2, 1.5);
  for (const bool noise_driven : {true, false}) {
    const Clustered found = clusterOn(mesh, [&](Clustering& clustering) {
      clustering.setNoiseDriven(noise_driven);
      clustering.setClusterTolerance(10); // of the paper: the whole wall
    });
    ASSERT_EQ(found.patches.size(), 1U);
    EXPECT_EQ(leftOut(found), 0U);
    const PlanePatch& patch = found.patches[0];
    EXPECT_TRUE(patch.coefficients.isApprox(Eigen::Vector4d(0, 0, 1, 0), 1e-9))
        << patch.coefficients.transpose();
    EXPECT_LT(patch.center.norm(), 1e-6);
    EXPECT_EQ(patch.support, mesh.cloud.size());
    EXPECT_EQ(patch.rms, 0);
    EXPECT_NEAR(patch.area, 3, 1e-6);
    EXPECT_LT(patch.covariance.cwiseAbs().maxCoeff(), 1e-20) << "nothing is unsure";
    EXPECT_NEAR(patch.effective_support, static_cast<double>(patch.support), 1e-9);
  }
}

TEST(PlaneShapes, inclinedPlaneIsExact)
{
  const VotingMesh mesh = makeSheetMesh(41, 31, grid, [](double u, double v) {
    return Eigen::Vector3d(u, v, 3 + u / 4);
  });
  const Clustered found = clusterOn(mesh);
  ASSERT_EQ(found.patches.size(), 1U);
  const Eigen::Vector3d normal = Eigen::Vector3d(-0.25, 0, 1).normalized();
  EXPECT_LT((found.patches[0].coefficients.head<3>() - normal).norm(), 1e-6);
  EXPECT_NEAR(found.patches[0].coefficients[3], -3 * normal.z(), 1e-6);
}

TEST(PlaneShapes, frameOfThePatchIsRightHandedAndInThePlane)
{
  const VotingMesh mesh = makeSheetMesh(61, 31, grid, [](double u, double v) {
    return Eigen::Vector3d(u, v, u / 4 - v);
  });
  const Clustered found = clusterOn(withNoise(mesh, {0, 0, 1}, 0.002));
  ASSERT_EQ(found.patches.size(), 1U);
  const PlanePatch& patch = found.patches[0];
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  EXPECT_NEAR(normal.norm(), 1, 1e-12);
  EXPECT_NEAR(patch.axis_u.norm(), 1, 1e-9);
  EXPECT_LT((patch.axis_u.cross(patch.axis_v) - normal).norm(), 1e-9);
  EXPECT_NEAR(distanceFrom(patch, patch.center), 0, 1e-9);
  EXPECT_LT(patch.center.norm(), 0.01);
}

TEST(PlaneShapes, gentlyCurvedWallIsNoPlane)
{
  for (const double noise : {0.0, 0.0005, 0.005})
    expectNoPlane(makeCurvedWall(8, noise));
}

TEST(PlaneShapes, sphereIsNoPlane)
{
  expectNoPlane(makeSphereMesh(4, 1));
  expectNoPlane(withNoise(makeSphereMesh(5, 1), {1, 0, 0}, 0.001));
}

TEST(PlaneShapes, noisyWallIsNotCurved)
{
  for (const double noise : {0.001, 0.005, 0.01}) {
    const Clustered found = clusterOn(withNoise(makeWall(4, 2.5), {0, 0, 1}, noise));
    ASSERT_EQ(found.patches.size(), 1U) << noise;
    EXPECT_EQ(found.report.curved_regions, 0U);
    EXPECT_NEAR(found.report.sigma, noise, 0.15 * noise);
    EXPECT_NEAR(found.patches[0].rms, noise, 0.1 * noise);
  }
}

TEST(PlaneShapes, leastAreaDecides)
{
  const VotingMesh mesh =
      together(makeWall(1, 1), placedAt(makeWall(0.5, 0.5), 3, 0, 0.7));
  const auto foundAbove = [&](double area) {
    return clusterOn(mesh, [&](Clustering& clustering) { clustering.setMinArea(area); })
        .patches.size();
  };
  EXPECT_EQ(foundAbove(0.1), 2U);
  EXPECT_EQ(foundAbove(0.5), 1U);
  EXPECT_EQ(foundAbove(1.5), 0U);
}

TEST(PlaneShapes, largestComesFirst)
{
  VotingMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh = together(mesh, placedAt(makeWall(0.5 + 0.2 * (k * 3 % 8), 1), 0, 0, k));
  const Clustered found = clusterOn(mesh);
  ASSERT_EQ(found.patches.size(), 8U);
  for (std::size_t p = 1; p < found.patches.size(); ++p)
    EXPECT_LE(found.patches[p].area, found.patches[p - 1].area);
}

/** It has less than a hundredth of the points. */
TEST(PlaneShapes, smallCurvedSurfaceIsTheReason)
{
  VotingMesh ball = makeSphereMesh(4, 1);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  ball.cloud.resize(110 * ball.cloud.size(), PointXYZ(nan, nan, nan));
  const Clustered found = clusterOn(ball);
  EXPECT_TRUE(found.patches.empty());
  EXPECT_GT(found.report.curved_regions, 0U);
  ASSERT_FALSE(found.report.remarks.empty());
  const std::string curved =
      " " + std::to_string(found.report.curved_regions) + " are curved";
  EXPECT_NE(found.report.remarks.back().find(curved), std::string::npos)
      << found.report.remarks.back();
}

} // namespace
} // namespace pcl::acmap::test
