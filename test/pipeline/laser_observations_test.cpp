#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/carmen_log.h>
#include <pcl/core/point_types.h>
#include <pcl/pipeline/laser_observations.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace pcl::acmap::test {
namespace {

/** Scans of a wall 2 m ahead, from places along it. */
std::vector<PlanarScan>
scansOfAWall(std::size_t count, double stamp_step = 1)
{
  std::vector<PlanarScan> scans(count);
  for (std::size_t i = 0; i < count; ++i) {
    PlanarScan& scan = scans[i];
    scan.first_angle = -M_PI / 2;
    scan.angle_step = M_PI / 180;
    scan.maximum_range = 8;
    for (int beam = 0; beam <= 180; ++beam)
      scan.ranges.push_back(
          std::min(8.0F, static_cast<float>(2 / std::cos((beam - 90) * M_PI / 180))));
    scan.pose.x = static_cast<double>(i);
    scan.stamp = stamp_step * static_cast<double>(i);
  }
  return scans;
}

TEST(LaserObservations, AreTheEchoesOfEachNthScan)
{
  const LaserObservations seen = observationsOf(scansOfAWall(5), 2);
  ASSERT_EQ(seen.clouds.size(), 3U);
  EXPECT_EQ(seen.scans.size(), 3U);
  EXPECT_EQ(seen.trajectory.stamps, (std::vector<double>{0, 2, 4}));
  EXPECT_NEAR(seen.trajectory.poses[2].translation().x(), 4, 1e-12);
  EXPECT_EQ(seen.weights[0].size(), seen.clouds[0]->size());
  EXPECT_EQ(seen.points, 3 * seen.clouds[0]->size());
  EXPECT_EQ(seen.points + seen.missing_beams, 3 * 181U);
  EXPECT_GT(seen.missing_beams, 0U);
  EXPECT_TRUE(seen.remarks.empty());
  EXPECT_EQ(observationsOf(scansOfAWall(2), 0).clouds.size(), 2U);
  EXPECT_EQ(observationsOf(scansOfAWall(2), SIZE_MAX).clouds.size(), 1U);
  EXPECT_TRUE(observationsOf({}).clouds.empty());
}

TEST(LaserObservations, HaveNumbersWhereStampsDoNotGrow)
{
  const LaserObservations seen = observationsOf(scansOfAWall(5, 0), 2);
  EXPECT_EQ(seen.trajectory.stamps, (std::vector<double>{0, 2, 4}));
  EXPECT_EQ(seen.remarks.size(), 1U);
}

TEST(LaserObservations, EchoesStandUnderTheirNewPoses)
{
  const LaserObservations seen = observationsOf(scansOfAWall(2));
  std::vector<Eigen::Isometry3d> poses = seen.trajectory.poses;
  poses[1].translation().z() += 1;
  PointCloud<PointXYZ> echoes;
  fromPCLPointCloud2(echoesOf(seen, poses).copy(), echoes);
  ASSERT_EQ(echoes.size(), seen.points);
  EXPECT_NEAR(echoes.front().z, 2, 1e-5);
  EXPECT_NEAR(echoes.back().z, 3, 1e-5);
  EXPECT_THROW(echoesOf(seen, {poses[0]}), BadArgumentException);
}

TEST(LaserObservations, AreWrittenAsALogAndAsATable)
{
  const TemporaryFolder folder;
  const LaserObservations seen = observationsOf(scansOfAWall(2));
  std::vector<Eigen::Isometry3d> poses = seen.trajectory.poses;
  poses[1].translation().z() += 0.5;
  saveCorrectedLog(folder.path("a.log"), seen, poses);
  const CarmenLog read = loadCarmenLog(folder.path("a.log"));
  ASSERT_EQ(read.scans.size(), 2U);
  EXPECT_NEAR(read.scans[1].pose.z, 0.5, 1e-6);
  savePlanarPoses(folder.path("poses.txt"), seen, poses);
  std::istringstream table(contentOf(folder.path("poses.txt")));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line.front(), '#');
  std::getline(table, line);
  double stamp = 0, forward = 0, left = 0, turned = 1;
  table >> stamp >> forward >> left >> turned;
  EXPECT_EQ(stamp, 1);
  EXPECT_EQ(forward, 0.5);
  EXPECT_EQ(left, -1);
  EXPECT_EQ(turned, 0);
  EXPECT_THROW(saveCorrectedLog(folder.path("b.log"), seen, {}), BadArgumentException);
  EXPECT_THROW(savePlanarPoses(folder.path("b.txt"), seen, {}), BadArgumentException);
  EXPECT_EQ(folder.count(), 2);
}

} // namespace
} // namespace pcl::acmap::test
