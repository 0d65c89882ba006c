#include <pcl/core/exceptions.h>
#include <pcl/core/planar_scan.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr double degree = M_PI / 180;
constexpr float infinity = std::numeric_limits<float>::infinity();

PlanarScan
halfTurn(int beams)
{
  PlanarScan scan;
  scan.first_angle = -M_PI / 2;
  scan.angle_step = M_PI / (beams - 1);
  scan.maximum_range = 30;
  scan.ranges.resize(static_cast<std::size_t>(beams), 30);
  return scan;
}

double
angleOf(const PlanarScan& scan, std::size_t beam)
{
  return scan.first_angle + static_cast<double>(beam) * scan.angle_step;
}

/** A wall whose normal, towards the laser, has the direction (sin, cos) of an angle. */
PlanarScan
scanOfWall(double distance, double normal_angle, double noise)
{
  Random random(5);
  PlanarScan scan = halfTurn(361);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double cosine = -std::cos(angleOf(scan, i) - normal_angle);
    if (cosine > 0.3)
      scan.ranges[i] = static_cast<float>(distance / cosine + noise * random.normal());
  }
  return scan;
}

std::size_t
withNormal(const PointCloud<PointNormal>& cloud)
{
  std::size_t count = 0;
  for (const PointNormal& point : cloud)
    count += point.getNormalVector3fMap().allFinite();
  return count;
}

TEST(PlanarScan, beamsGoFromAheadToTheRight)
{
  PlanarScan scan = halfTurn(3);
  scan.ranges = {1, 2, 3};
  const PointCloud<PointNormal> cloud = *pointsOf(scan).cloud;
  ASSERT_EQ(cloud.size(), 3U);
  EXPECT_TRUE(cloud[0].getVector3fMap().isApprox(Eigen::Vector3f(-1, 0, 0), 1e-6F));
  EXPECT_TRUE(cloud[1].getVector3fMap().isApprox(Eigen::Vector3f(0, 0, 2), 1e-6F));
  EXPECT_TRUE(cloud[2].getVector3fMap().isApprox(Eigen::Vector3f(3, 0, 0), 1e-6F));
}

TEST(PlanarScan, beamsWithoutEchoAreCounted)
{
  PlanarScan scan = halfTurn(9);
  scan.ranges = {0, -1, std::nanf(""), infinity, 30, 31, 29.9F, 1, -infinity};
  const PlanarScanPoints points = pointsOf(scan);
  EXPECT_EQ(points.cloud->size(), 2U);
  EXPECT_EQ(points.weights.size(), 2U);
  EXPECT_EQ(points.missing_beams, 7U);
}

TEST(PlanarScan, normalsAreTheWallsTowardsTheLaser)
{
  for (const double turn : {180.0, 150.0, 225.0}) {
    const Eigen::Vector3d wanted(std::sin(turn * degree), 0, std::cos(turn * degree));
    const PlanarScanPoints points = pointsOf(scanOfWall(3, turn * degree, 0));
    ASSERT_GT(points.cloud->size(), 100U);
    EXPECT_EQ(withNormal(*points.cloud), points.cloud->size());
    for (const PointNormal& point : *points.cloud) {
      EXPECT_LT((point.getNormalVector3fMap().cast<double>() - wanted).norm(), 1e-3);
      EXPECT_NEAR(point.getVector3fMap().cast<double>().dot(wanted), -3, 1e-5);
    }
  }
}

TEST(PlanarScan, theSenseOfTheSweepDoesNotMatter)
{
  const PlanarScan scan = scanOfWall(2, 190 * degree, 0.002);
  PlanarScan back = scan;
  std::reverse(back.ranges.begin(), back.ranges.end());
  back.first_angle = angleOf(scan, scan.ranges.size() - 1);
  back.angle_step = -scan.angle_step;
  const PlanarScanPoints wanted = pointsOf(scan), found = pointsOf(back);
  ASSERT_EQ(found.cloud->size(), wanted.cloud->size());
  for (std::size_t i = 0; i < wanted.cloud->size(); ++i) {
    const std::size_t j = wanted.cloud->size() - 1 - i;
    const PointNormal& a = (*wanted.cloud)[i];
    const PointNormal& b = (*found.cloud)[j];
    EXPECT_LT((a.getVector3fMap() - b.getVector3fMap()).norm(), 1e-5F);
    EXPECT_LT((a.getNormalVector3fMap() - b.getNormalVector3fMap()).norm(), 1e-3F);
    EXPECT_NEAR(wanted.weights[i], found.weights[j], 1e-4F);
  }
}

TEST(PlanarScan, weightsAddUpToTheLengthOfTheWall)
{
  const PlanarScanPoints points = pointsOf(scanOfWall(4, 180 * degree, 0));
  double length = 0;
  for (const float weight : points.weights)
    length += weight;
  const double ends = 2 * 4 * std::tan(std::acos(0.3));
  EXPECT_NEAR(length, ends, 0.02 * ends);
}

TEST(PlanarScan, weightsStayWithinTwoAndFiftyCentimetres)
{
  PlanarScan scan = halfTurn(3);
  scan.ranges = {0.001F, 1, 29};
  const PlanarScanPoints points = pointsOf(scan);
  EXPECT_EQ(points.weights[0], 0.02F);
  EXPECT_EQ(points.weights[1], 0.5F) << "2 m between beams";
  EXPECT_EQ(points.weights[2], 0.5F);
}

TEST(PlanarScan, scatteredEchoesHaveNoNormal)
{
  Random random(6);
  PlanarScan scan = halfTurn(181);
  for (float& range : scan.ranges)
    range = static_cast<float>(random.uniform(1, 20));
  const PlanarScanPoints points = pointsOf(scan);
  ASSERT_EQ(points.cloud->size(), 181U);
  EXPECT_LT(withNormal(*points.cloud), 10U);
  for (const PointNormal& point : *points.cloud)
    EXPECT_EQ(std::isfinite(point.normal_x), std::isfinite(point.normal_z));
}

TEST(PlanarScan, wallsBehindEachOtherDoNotShareANormal)
{
  PlanarScan scan = scanOfWall(3, 180 * degree, 0);
  const std::size_t middle = scan.ranges.size() / 2;
  for (std::size_t i = middle; i < scan.ranges.size(); ++i)
    if (scan.ranges[i] < 30)
      scan.ranges[i] *= 2;
  const PlanarScanPoints points = pointsOf(scan);
  for (const PointNormal& point : *points.cloud)
    if (std::isfinite(point.normal_z)) {
      EXPECT_LT(point.normal_z, -0.999F);
    }
  EXPECT_GE(withNormal(*points.cloud) + 4, points.cloud->size());
}

TEST(PlanarScan, aLonelyEchoHasNoNormalAndOneWeight)
{
  PlanarScan scan = halfTurn(181);
  scan.ranges[90] = 2;
  const PlanarScanPoints points = pointsOf(scan);
  ASSERT_EQ(points.cloud->size(), 1U);
  EXPECT_EQ(withNormal(*points.cloud), 0U);
  EXPECT_NEAR(points.weights[0], 2 * degree, 1e-6);
}

TEST(PlanarScan, nothingGivesNothing)
{
  const PlanarScanPoints points = pointsOf({});
  ASSERT_TRUE(points.cloud);
  EXPECT_TRUE(points.cloud->empty());
  EXPECT_TRUE(points.weights.empty());
  EXPECT_EQ(points.missing_beams, 0U);
}

TEST(PlanarScan, withoutAStepAllEchoesLieOnOneBeam)
{
  PlanarScan scan = halfTurn(5);
  scan.angle_step = 0;
  scan.ranges = {1, 1, 1, 1, 1};
  const PlanarScanPoints points = pointsOf(scan);
  EXPECT_EQ(points.cloud->size(), 5U);
  EXPECT_EQ(withNormal(*points.cloud), 0U);
  for (const float weight : points.weights)
    EXPECT_EQ(weight, 0.02F);
}

TEST(PlanarScan, rangesAsHugeAsFloatsGiveFiniteWeights)
{
  PlanarScan scan = halfTurn(7);
  scan.maximum_range = infinity;
  scan.ranges.assign(7, 3e38F);
  const PlanarScanPoints points = pointsOf(scan);
  EXPECT_EQ(points.cloud->size(), 7U);
  for (const float weight : points.weights)
    EXPECT_TRUE(std::isfinite(weight));
}

TEST(PlanarScan, anglesThatAreNotFiniteAreRefused)
{
  for (const double bad : {std::nan(""), double(infinity), -double(infinity)}) {
    PlanarScan scan = halfTurn(3);
    scan.first_angle = bad;
    EXPECT_THROW(pointsOf(scan), BadArgumentException);
    scan = halfTurn(3);
    scan.angle_step = bad;
    EXPECT_THROW(pointsOf(scan), BadArgumentException);
  }
}

} // namespace
} // namespace pcl::acmap::test
