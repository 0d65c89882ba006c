#include "messages.h"
#include "temporary_folder.h"

#include <pcl/core/random.h>
#include <pcl/core/trajectory.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

Trajectory
randomWalk(std::size_t poses)
{
  Random random(11);
  Trajectory trajectory;
  for (std::size_t i = 0; i < poses; ++i) {
    const Eigen::Quaterniond rotation(
        random.normal(), random.normal(), random.normal(), random.normal());
    Eigen::Isometry3d pose(rotation.normalized());
    pose.translation() =
        100.0 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    trajectory.stamps.push_back(1305031102.175304 + 0.1 * static_cast<double>(i));
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

TEST(Trajectory, SurvivesItsFile)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("trajectory.txt");
  const Trajectory walk = randomWalk(200);
  saveTrajectory(path, walk);
  const Trajectory read = loadTrajectory(path);
  EXPECT_EQ(read.stamps, walk.stamps);
  ASSERT_EQ(read.poses.size(), walk.poses.size());
  for (std::size_t i = 0; i < walk.poses.size(); ++i) {
    EXPECT_EQ(read.poses[i].translation(), walk.poses[i].translation());
    EXPECT_TRUE(read.poses[i].linear().isApprox(walk.poses[i].linear(), 1e-14));
  }
  EXPECT_EQ(folder.count(), 1);
}

TEST(Trajectory, ReadsTheFormOfTum)
{
  const TemporaryFolder folder;
  const Trajectory read =
      loadTrajectory(folder.write("t.txt",
                                  "# ground truth\r\n\r\n"
                                  "1.5 1 2 3 0 0 0 1 # the first\r\n"
                                  "  2.5\t-1e-3 +2 3 0 0.7071 0 0.7071"));
  EXPECT_EQ(read.stamps, (std::vector<double>{1.5, 2.5}));
  EXPECT_EQ(read.poses[0].translation(), Eigen::Vector3d(1, 2, 3));
  // A quarter turn about y takes z to x.
  EXPECT_TRUE((read.poses[1].linear() * Eigen::Vector3d::UnitZ())
                  .isApprox(Eigen::Vector3d::UnitX(), 1e-12));
}

std::string
faultOfWay(const std::string& text)
{
  const TemporaryFolder folder;
  return messageOf<InputFileException>(
      [&] { loadTrajectory(folder.write("t.txt", text)); });
}

TEST(Trajectory, FaultsAreNamedWithTheirLine)
{
  const std::string good = "0 0 0 0 0 0 0 1\n";
  EXPECT_THAT(faultOfWay(good + "1 0 0 0 0 0 0\n"),
              HasSubstr("t.txt: line 2: has 7 numbers, 8 are needed"));
  EXPECT_THAT(faultOfWay("#\n" + good + "1 0 0 0 0 0 0 1 9\n"),
              HasSubstr("line 3: has 9"));
  EXPECT_THAT(faultOfWay("0 0 0 x 0 0 0 1\n"), HasSubstr("line 1: 'x' is no finite"));
  EXPECT_THAT(faultOfWay("0 0 0 nan 0 0 0 1\n"), HasSubstr("'nan' is no finite"));
  EXPECT_THAT(faultOfWay("0 0 0 0 0 0 0 1.02\n"), HasSubstr("line 1: the quaternion"));
  EXPECT_THAT(faultOfWay("0 0 0 0 0 0 0 0\n"), HasSubstr("has length 0"));
  EXPECT_THAT(faultOfWay("# nothing\n"), HasSubstr("has no row"));
  EXPECT_THAT(faultOfWay(""), HasSubstr("is empty"));
}

TEST(Trajectory, AlmostUnitQuaternionIsNormalised)
{
  const TemporaryFolder folder;
  const auto read = loadTrajectory(folder.write("t.txt", "0 0 0 0 0 0 0 1.009\n"));
  EXPECT_TRUE(read.poses[0].linear().isIdentity(1e-15));
}

TEST(Trajectory, WhatIsNoMotionIsNotWritten)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("t.txt");
  Trajectory walk = randomWalk(2);
  walk.stamps.pop_back();
  EXPECT_THROW(saveTrajectory(path, walk), BadArgumentException);
  walk = randomWalk(2);
  walk.poses[1].linear() *= 1.1;
  EXPECT_THROW(saveTrajectory(path, walk), BadArgumentException);
  walk = randomWalk(2);
  walk.poses[1].linear().col(0) *= -1.0;
  EXPECT_THROW(saveTrajectory(path, walk), BadArgumentException);
  walk = randomWalk(2);
  walk.stamps[0] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(saveTrajectory(path, walk), BadArgumentException);
  EXPECT_EQ(folder.count(), 0);
}

} // namespace
} // namespace pcl::acmap::test
