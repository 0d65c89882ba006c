#include "closed_meshes.h"
#include "clustering_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

/** The paper's thresholds, but all points are within W_d of each other. */
void
setPaperMode(Clustering& clustering)
{
  clustering.setNoiseDriven(false);
  clustering.setClusterTolerance(10);
}

TEST(PartedPlanes, boardsTwelveCentimetresApartAreTwo)
{
  for (const double noise : {0.0, 0.002, 0.005}) {
    const Clustered found = clusterOn(withNoise(makeBoards(0.12), {0, 0, 1}, noise));
    ASSERT_EQ(found.patches.size(), 2U) << noise;
    EXPECT_EQ(leftOut(found), 0U);
    const double apart = std::abs(distanceFrom(found.patches[0], {0, 0, 0}) -
                                  distanceFrom(found.patches[1], {0, 0, 0}));
    EXPECT_NEAR(apart, 0.12, 0.001 + noise / 5);
    for (const PlanePatch& patch : found.patches) {
      EXPECT_LT(angleFrom(patch, {0, 0, 1}), 0.1 * degree);
      EXPECT_NEAR(patch.rms, noise, 0.1 * noise + 1e-9);
      EXPECT_NEAR(patch.area, 3, 0.05);
    }
  }
}

TEST(PartedPlanes, cornerOfABoxHasThree)
{
  const Clustered found = clusterOn(withNoise(makeCornerMesh(), {1, 1, 1}, 0.0005));
  ASSERT_EQ(found.patches.size(), 3U);
  for (int axis = 0; axis < 3; ++axis) {
    std::size_t count = 0;
    for (const PlanePatch& patch : found.patches) {
      count += angleFrom(patch, Eigen::Vector3d::Unit(axis)) < 0.1 * degree;
      EXPECT_GT(patch.coefficients.head<3>().sum(), 0.9)
          << "to the side it is seen from";
    }
    EXPECT_EQ(count, 1U) << "along axis " << axis;
  }
}

TEST(PartedPlanes, cubeHasSix)
{
  const Clustered found = clusterOn(makeCubeMesh(20, grid));
  ASSERT_EQ(found.patches.size(), 6U);
  EXPECT_EQ(leftOut(found), 0U);
  for (const PlanePatch& patch : found.patches) {
    EXPECT_NEAR(patch.coefficients[3], -0.5, 1e-6);
    EXPECT_NEAR(patch.area, 1, 1e-5);
  }
}

TEST(PartedPlanes, doorThatLiesTenCentimetresBack)
{
  const VotingMesh mesh = withNoise(makeDoor(0.1), {0, 0, 1}, 0.0005);
  const Clustered found = clusterOn(mesh);
  ASSERT_EQ(found.patches.size(), 2U);
  EXPECT_EQ(found.patches[0].polygons.size(), 2U) << "wall on both sides of the door";
  EXPECT_NEAR(found.patches[0].area, 6, 0.1);
  EXPECT_NEAR(distanceFrom(found.patches[0], {0, 0, 0}), 0, 0.001);
  EXPECT_EQ(found.patches[1].polygons.size(), 1U);
  EXPECT_NEAR(found.patches[1].area, 1.8, 0.1);
  EXPECT_NEAR(distanceFrom(found.patches[1], {0, 0, -0.1}), 0, 0.001);
  EXPECT_EQ(clusterOn(mesh, setPaperMode).patches.size(), 1U);
}

TEST(PartedPlanes, boardsFarApartInOnePlaneAreOne)
{
  const VotingMesh board = makeWall(1, 2);
  const VotingMesh boards =
      together(placedAt(board, -3, 0, -0.1), placedAt(board, 3, 0, -0.1));
  for (const double noise : {0.0, 0.001, 0.003}) {
    const VotingMesh mesh =
        withNoise(together(makeWall(8, 2.5), boards), {0, 0, 1}, noise);
    const Clustered found = clusterOn(mesh);
    ASSERT_EQ(found.patches.size(), 2U) << noise;
    EXPECT_EQ(found.report.merged, 1U);
    EXPECT_EQ(found.patches[1].polygons.size(), 2U);
    EXPECT_NEAR(found.patches[1].area, 4, 0.1);
    EXPECT_NEAR(distanceFrom(found.patches[1], {0, 0, -0.1}), 0, 0.001);
  }
}

TEST(PartedPlanes, sidesOfAThinWallAreTwo)
{
  for (const double noise : {0.0, 0.002})
    for (const bool noise_driven : {true, false}) {
      const VotingMesh mesh = withNoise(makeThinWall(0.12), {0, 0, 1}, noise);
      const Clustered found = clusterOn(mesh, [&](Clustering& clustering) {
        if (!noise_driven)
          setPaperMode(clustering);
      });
      ASSERT_EQ(found.patches.size(), 2U) << noise << ", " << noise_driven;
      const Eigen::Vector3d front = found.patches[0].coefficients.head<3>();
      const Eigen::Vector3d back = found.patches[1].coefficients.head<3>();
      EXPECT_LT(front.dot(back), -0.999) << "each looks to its side";
      EXPECT_EQ(found.patches[0].support, found.patches[1].support);
    }
}

} // namespace
} // namespace pcl::acmap::test
