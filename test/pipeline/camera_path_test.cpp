#include <pcl/pipeline/camera_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pcl {
namespace {

using Poses = std::vector<Eigen::Isometry3d>;

constexpr double degree = M_PI / 180;

/** A robot that drives a curve in a plane, whose camera is mounted as it may be. */
Poses
drive(const Eigen::Quaterniond& mounting, double turn)
{
  Poses poses;
  Eigen::Isometry3d robot = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 40; ++i) {
    poses.push_back(mounting.inverse() * robot * mounting);
    robot.translate(Eigen::Vector3d(0, 0, 0.2));
    robot.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()));
  }
  return poses;
}

/** The same, held by a hand. */
Poses
shaken(Poses poses, double tilt)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (Eigen::Isometry3d& pose : poses)
    pose.rotate(Eigen::AngleAxisd(tilt * normal(random), Eigen::Vector3d::UnitX()) *
                Eigen::AngleAxisd(tilt * normal(random), Eigen::Vector3d::UnitZ()));
  return poses;
}

TEST(CameraPath, OfARobotIsPlanarWhateverTheMounting)
{
  for (const double turn : {0.0, 0.02, 0.1, 0.5})
    for (const double pitch : {0.0, 0.3, 1.2}) {
      const Eigen::Quaterniond mounting(
          Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()));
      const CameraPathReport path = judgePath(freeMotionOf(drive(mounting, turn)));
      EXPECT_FALSE(path.is_in_space) << turn << " " << pitch;
      EXPECT_GT(path.confidence, 0.95);
      EXPECT_LT(path.evidence.tilt, 1e-6);
    }
}

TEST(CameraPath, WithSmallErrorsStaysPlanar)
{
  const Poses poses = shaken(drive(Eigen::Quaterniond::Identity(), 0.05), 0.2 * degree);
  EXPECT_FALSE(judgePath(freeMotionOf(poses)).is_in_space);
}

TEST(CameraPath, OfAHandIsInSpace)
{
  const Poses poses = shaken(drive(Eigen::Quaterniond::Identity(), 0.05), 3 * degree);
  const CameraPathReport path = judgePath(freeMotionOf(poses));
  EXPECT_TRUE(path.is_in_space);
  EXPECT_EQ(textOf(path).rfind("in space, 0.99 (tilts by ", 0), 0U) << textOf(path);
}

TEST(CameraPath, OfTripodsOfDifferentHeightsIsPlanar)
{
  Poses poses = drive(Eigen::Quaterniond::Identity(), 0.5);
  for (std::size_t i = 0; i < poses.size(); i += 2)
    poses[i].translation().y() += 0.1;
  EXPECT_FALSE(judgePath(freeMotionOf(poses)).is_in_space);
}

TEST(CameraPath, IsAssumedPlanarWithoutMotion)
{
  for (const Poses& poses : {Poses(),
                             Poses(1, Eigen::Isometry3d::Identity()),
                             Poses(9, Eigen::Isometry3d::Identity())}) {
    const CameraPathReport path = judgePath(freeMotionOf(poses));
    EXPECT_FALSE(path.is_in_space);
    EXPECT_EQ(path.evidence.pairs, 0U);
    EXPECT_EQ(textOf(path), "planar, assumed (no motion tells)");
  }
}

TEST(CameraPath, IsTheMoreCertainTheMoreMotionsAgree)
{
  EXPECT_NEAR(judgePath({5, 5, 0, 0}).confidence, 0.984, 0.001);
  EXPECT_NEAR(judgePath({5, 0, 0, 0}).confidence, 0.984, 0.001);
  EXPECT_NEAR(judgePath({1, 1, 0, 0}).confidence, 0.75, 0.001);
  EXPECT_LT(judgePath({5, 3, 0, 0}).confidence, 0.7);
}

} // namespace
} // namespace pcl
