#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using Points = Eigen::Matrix3Xd;

Points
randomPoints(Random& random, Eigen::Index count)
{
  Points points(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    points.col(i) << random.normal(), random.normal(), random.normal();
  return points.colwise() - points.rowwise().mean();
}

Eigen::Matrix3d
randomRotation(Random& random)
{
  const Eigen::Vector4d q(
      random.normal(), random.normal(), random.normal(), random.normal());
  return Eigen::Quaterniond(q).normalized().toRotationMatrix();
}

TEST(RigidAlignment, findsTheRotationOfPointsAndOfPlanes)
{
  Random random(1);
  for (int run = 0; run < 50; ++run) {
    Points points = randomPoints(random, 3 + run);
    if (run % 2 == 1)
      points.row(run % 3).setZero();
    const Eigen::Matrix3d wanted = randomRotation(random);
    const Eigen::Matrix3d found =
        alignmentRotation<3>(wanted * points * points.transpose());
    EXPECT_LT((found - wanted).norm(), 1e-9);
    EXPECT_GT(found.determinant(), 0);
  }
}

/** No rotation nearby has a smaller sum of squares, for noisy and for mirrored points.
 */
TEST(RigidAlignment, isTheBestAndNoReflection)
{
  Random random(2);
  for (int run = 0; run < 20; ++run) {
    const Points from = randomPoints(random, 20);
    Points to = randomRotation(random) * from + 0.3 * randomPoints(random, 20);
    if (run % 2 == 1)
      to.row(0) *= -1;
    const Eigen::Matrix3d found = alignmentRotation<3>(to * from.transpose());
    EXPECT_NEAR(found.determinant(), 1, 1e-9);
    const double best = (found * from - to).squaredNorm();
    for (int axis = 0; axis < 3; ++axis)
      for (const double angle : {-1e-3, 1e-3, M_PI})
        EXPECT_LT(
            best,
            (Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)) * found * from - to)
                .squaredNorm());
  }
}

TEST(RigidAlignment, isTheSmallestRotationOfALine)
{
  const Eigen::Vector3d from = Eigen::Vector3d(1, 2, 2), to(2, 2, -1);
  const Eigen::Matrix3d found = alignmentRotation<3>(to * from.transpose(), 1e-9);
  EXPECT_LT((found * from - to).norm(), 1e-9);
  EXPECT_NEAR(Eigen::AngleAxisd(found).angle(), std::acos(4.0 / 9), 1e-9);
}

TEST(RigidAlignment, isTheIdentityIfPointsCoincide)
{
  EXPECT_TRUE(alignmentRotation<3>(Eigen::Matrix3d::Zero()).isIdentity());
  EXPECT_TRUE(alignmentRotation<2>(Eigen::Matrix2d::Zero()).isIdentity());
  Eigen::Matrix3d rounding = 1e-13 * Eigen::Matrix3d::Identity();
  rounding(0, 0) = -1e-13;
  EXPECT_TRUE(alignmentRotation<3>(rounding, 1e-12).isIdentity());
}

TEST(RigidAlignment, findsRotationsOfTheFloor)
{
  for (const double angle : {-3.0, -0.1, 0.0, 2.0}) {
    const Eigen::Matrix2d wanted = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const Eigen::Vector2d line(3, -4);
    const Eigen::Matrix2d plane = Eigen::Vector2d(2, 0.1).asDiagonal();
    EXPECT_LT((alignmentRotation<2>(wanted * plane) - wanted).norm(), 1e-9);
    EXPECT_LT((alignmentRotation<2>(wanted * line * line.transpose()) - wanted).norm(),
              1e-9);
  }
}

} // namespace
} // namespace pcl::acmap::test
