#include <pcl/core/planar_pose.h>
#include <pcl/core/random.h>
#include <pcl/core/trajectory.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

PlanarPose
randomPose(Random& random)
{
  return {10 * random.normal(), 10 * random.normal(), random.uniform(-M_PI, M_PI)};
}

void
expectNear(const PlanarPose& found, const PlanarPose& wanted, double slack)
{
  EXPECT_NEAR(found.x, wanted.x, slack);
  EXPECT_NEAR(found.z, wanted.z, slack);
  EXPECT_NEAR(std::remainder(found.theta - wanted.theta, 2 * M_PI), 0, slack);
}

TEST(PlanarPose, aQuarterTurnLooksAlongX)
{
  const Eigen::Isometry3d T_map_robot = isometryOf({3, 5, M_PI / 2});
  const Eigen::Vector3d ahead = T_map_robot * Eigen::Vector3d(0, 7, 1);
  EXPECT_LT((ahead - Eigen::Vector3d(4, 7, 5)).norm(), 1e-12);
}

TEST(PlanarPose, actionsAreSeenFromWhereTheRobotStood)
{
  expectNear(moved({1, 2, M_PI / 2}, {0, 3, 0.1}), {4, 2, M_PI / 2 + 0.1}, 1e-12);
  expectNear(moved({1, 2, M_PI / 2}, {3, 0, 0}), {1, -1, M_PI / 2}, 1e-12);
}

TEST(PlanarPose, actionsAreThoseOfRigidMotions)
{
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const PlanarPose from = randomPose(random);
    const PlanarPose by = randomPose(random);
    const PlanarPose to = moved(from, {by.x, by.z, by.theta});
    EXPECT_TRUE(isometryOf(to).isApprox(isometryOf(from) * isometryOf(by), 1e-12));
    const PlanarAction action = actionBetween(from, to);
    expectNear({action.dx, action.dz, action.dtheta}, by, 1e-12);
  }
}

TEST(PlanarPose, turnsBetweenPosesAreShort)
{
  for (const double turns : {0.0, 2 * M_PI, -6 * M_PI}) {
    const PlanarAction action = actionBetween({0, 0, 3}, {0, 0, turns - 3});
    EXPECT_NEAR(action.dtheta, 2 * M_PI - 6, 1e-12);
  }
}

TEST(PlanarPose, survivesSpace)
{
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const PlanarPose pose = randomPose(random);
    expectNear(planarPartOf(isometryOf(pose)), pose, 1e-12);
  }
}

/** Similarity between the rotation of a pose and a planar rotation: the trace, which is
 * to be maximal. */
double
nearness(const Eigen::Isometry3d& T_map_camera, double theta)
{
  return (isometryOf({0, 0, theta}).linear().transpose() * T_map_camera.linear())
      .trace();
}

TEST(PlanarPose, thePlanarPartIsTheNearest)
{
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    Eigen::Isometry3d pose =
        isometryOf(randomPose(random)) *
        Eigen::AngleAxisd(0.4 * random.normal(), Eigen::Vector3d::UnitX()) *
        Eigen::AngleAxisd(0.4 * random.normal(), Eigen::Vector3d::UnitZ());
    pose.translation().y() = random.normal();
    const PlanarPose part = planarPartOf(pose);
    EXPECT_EQ(part.x, pose.translation().x());
    EXPECT_EQ(part.z, pose.translation().z());
    const double best = nearness(pose, part.theta);
    for (int degree = 1; degree < 360; ++degree)
      EXPECT_GE(best, nearness(pose, part.theta + degree * M_PI / 180));
  }
}

TEST(PlanarPose, noTurnIsToldOfWhatIsUpsideDown)
{
  Eigen::Isometry3d pose(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  pose.translation() << 1, 2, 3;
  const PlanarPose part = planarPartOf(pose);
  EXPECT_EQ(part.x, 1);
  EXPECT_EQ(part.z, 3);
  EXPECT_TRUE(std::isfinite(part.theta));
}

TEST(RigidMotion, isTold)
{
  Random random(4);
  EXPECT_TRUE(isRigid(Eigen::Isometry3d::Identity()));
  for (int i = 0; i < 50; ++i)
    EXPECT_TRUE(isRigid(isometryOf(randomPose(random))));
}

} // namespace
} // namespace pcl::acmap::test
