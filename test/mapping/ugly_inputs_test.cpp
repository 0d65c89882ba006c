#include "entropy_runs.h"

#include <pcl/core/exceptions.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace pcl::acmap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool
remarks(const MapEntropy<PointNormal>& entropy, const std::string& words)
{
  for (const std::string& remark : entropy.getReport().remarks)
    if (remark.find(words) != std::string::npos)
      return true;
  return false;
}

void
expectNoEntropy(MapEntropy<PointNormal>& entropy, const std::string& reason)
{
  std::vector<Eigen::Vector3d> gradient(17);
  for (const MapEntropyTerms& terms :
       {entropy.compute(), entropy.computeGradient(gradient), entropy.computeExact()}) {
    EXPECT_TRUE(areSame(terms, {}));
    EXPECT_TRUE(remarks(entropy, reason)) << reason;
  }
  ASSERT_EQ(gradient.size(), entropy.getNumberOfPointClouds());
  for (const Eigen::Vector3d& one : gradient)
    EXPECT_EQ(one, Eigen::Vector3d(0, 0, 0));
}

TEST(MapEntropyUgly, nothingWasAdded)
{
  MapEntropy<PointNormal> entropy;
  std::vector<Eigen::Vector3d> gradient(2, Eigen::Vector3d::Ones());
  EXPECT_THROW(entropy.compute(), InitFailedException);
  EXPECT_THROW(entropy.computeExact(), InitFailedException);
  EXPECT_THROW(entropy.computeGradient(gradient), InitFailedException);
  EXPECT_EQ(gradient.size(), 2U);
  EXPECT_THROW(entropy.addPointCloud(nullptr), BadArgumentException);
  EXPECT_EQ(entropy.getNumberOfPointClouds(), 0U);
}

TEST(MapEntropyUgly, oneObservationIsNamed)
{
  auto entropy = entropyOf(makeRoomViews(1, 500, 1), {});
  EXPECT_GT(entropy.compute().total, 1);
  EXPECT_TRUE(remarks(entropy, "one observation"));
  entropy.addPointCloud(makeRoomViews(1, 500, 1).clouds[0]);
  entropy.compute();
  EXPECT_FALSE(remarks(entropy, "one observation"));
}

TEST(MapEntropyUgly, noFinitePoint)
{
  MapEntropy<PointNormal> entropy;
  entropy.addPointCloud(cloudAt({}));
  expectNoEntropy(entropy, "no finite point");
  entropy.addPointCloud(cloudAt({{std::nan(""), 0}, {0, std::nan("")}, {infinity, 0}}));
  expectNoEntropy(entropy, "no finite point");
  EXPECT_EQ(entropy.getReport().points, 3U);
  EXPECT_EQ(entropy.getReport().invalid_points, 3U);
}

TEST(MapEntropyUgly, pointsThatAreNotFiniteDoNotCount)
{
  for (const bool directions : {false, true}) {
    NaiveEntropySettings settings;
    settings.directions = directions;
    PosedClouds map = makeRoomViews(2, 800, 2);
    const MapEntropyTerms wanted = entropyOf(map, settings).compute();
    const MapEntropyTerms exact = entropyOf(map, settings).computeExact();
    for (auto& cloud : map.clouds) {
      *cloud += *cloudAt({{std::nan(""), 1}, {1, -infinity}});
      cloud->push_back(cloud->front());
      cloud->back().y = std::nanf("");
    }
    map.clouds.push_back(cloudAt({}));
    map.poses.push_back({1, 2, 3});
    auto entropy = entropyOf(map, settings);
    EXPECT_TRUE(areSame(entropy.compute(), wanted));
    EXPECT_EQ(entropy.getReport().invalid_points, 6U);
    EXPECT_TRUE(areSame(entropy.computeExact(), exact));
    EXPECT_EQ(entropy.getReport().invalid_points, 6U);
  }
}

TEST(MapEntropyUgly, hugeCoordinatesAreNamed)
{
  for (const double far : {1e6, 9e8, -9e8}) {
    auto entropy = entropyOf(makeRoomViews(3, 100, 3), {});
    entropy.addPointCloud(cloudAt({{0, 0}, {far, far}}));
    expectNoEntropy(entropy, "The widest observation, 3,");
  }
  for (const double far : {2e9, -3e38}) {
    auto entropy = entropyOf(makeRoomViews(3, 100, 3), {});
    entropy.addPointCloud(cloudAt({{0, 0}, {0, far}}));
    expectNoEntropy(entropy, "1 points are 1e+09 m or more from their sensor");
    EXPECT_EQ(entropy.getReport().distant_points, 1U);
  }
}

TEST(MapEntropyUgly, posesFarApartAreNamed)
{
  auto entropy = entropyOf(makeRoomViews(2, 100, 3), {});
  entropy.setPose(1, {1e9, -1e9, 1e3});
  expectNoEntropy(entropy, "bins of 0.1 m");
  entropy.setPose(0, {1e9, -1e9, 1e3});
  EXPECT_GT(entropy.compute().joint, 1) << "far out, but together";
}

TEST(MapEntropyUgly, badPosesAreRefusedAndChangeNothing)
{
  auto entropy = entropyOf(makeRoomViews(2, 100, 3), {});
  const PlanarPose before = entropy.getPose(1);
  for (const double bad : {std::nan(""), infinity, -infinity, 1e12})
    for (int axis = 0; axis < 3; ++axis) {
      const PlanarPose pose = shifted({}, axis, bad);
      EXPECT_THROW(entropy.setPose(1, pose), BadArgumentException);
      EXPECT_THROW(entropy.addPointCloud(cloudAt({}), pose), BadArgumentException);
    }
  EXPECT_EQ(entropy.getPose(1).x, before.x);
  EXPECT_EQ(entropy.getPose(1).theta, before.theta);
  EXPECT_EQ(entropy.getNumberOfPointClouds(), 2U);
  EXPECT_THROW(entropy.setPose(2, before), BadArgumentException);
  EXPECT_THROW(entropy.getPose(2), BadArgumentException);
}

TEST(MapEntropyUgly, kernelWantsAPoseForEachObservation)
{
  MapEntropyReport report;
  EXPECT_THROW(mapEntropy(std::vector<EntropyCells>(2), {{0, 0, 0}}, {}, report),
               BadArgumentException);
}

TEST(MapEntropyUgly, smoothingWiderThanAHundredBinsIsRefused)
{
  auto entropy = entropyOf(makeRoomViews(2, 100, 3), {});
  entropy.setSmoothing(10.1);
  EXPECT_THROW(entropy.compute(), BadArgumentException);
  EXPECT_THROW(entropy.computeExact(), BadArgumentException);
  entropy.setSmoothing(2);
  EXPECT_GT(entropy.compute().total, 1);
}

TEST(MapEntropyUgly, withoutNormalsDirectionsPlayNoRole)
{
  PosedClouds map = makeRoomViews(2, 500, 4);
  for (auto& cloud : map.clouds)
    for (PointNormal& point : *cloud)
      point.getNormalVector3fMap().setConstant(std::nanf(""));
  NaiveEntropySettings settings;
  const MapEntropyTerms wanted = entropyOf(map, settings).compute();
  settings.directions = true;
  auto entropy = entropyOf(map, settings);
  EXPECT_NEAR(entropy.compute().total, wanted.total, 1e-12);
  EXPECT_TRUE(remarks(entropy, "no point has the normal of a wall"));
  EXPECT_EQ(entropy.getReport().layers, 9U);
}

TEST(MapEntropyUgly, pointsWithoutExtentAreNamed)
{
  NaiveEntropySettings settings;
  auto place = entropyOf(
      {{cloudAt({{1, 2}, {1, 2}}), cloudAt({{1, 2}})}, {{0, 0, 0}, {0, 0, 0}}},
      settings);
  EXPECT_EQ(place.compute().dimensions, 0);
  EXPECT_TRUE(remarks(place, "one place"));
  auto line = entropyOf(
      {{cloudAt({{0, 0}, {1, 2}}), cloudAt({{3, 6}})}, {{0, 0, 0}, {0, 0, 0}}},
      settings);
  EXPECT_EQ(line.compute().dimensions, 1);
  EXPECT_TRUE(remarks(line, "one line"));
  EXPECT_EQ(line.computeExact().dimensions, 1);
}

} // namespace
} // namespace pcl::acmap::test
