#include "entropy_runs.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

NaiveEntropySettings
settingsFor(bool directions)
{
  NaiveEntropySettings settings;
  settings.directions = directions;
  return settings;
}

TEST(MapEntropyProperties, orderOfPointsChangesNoByte)
{
  for (const bool directions : {false, true}) {
    PosedClouds map = makeRoomViews(3, 3000, 21);
    auto ordered = entropyOf(map, settingsFor(directions));
    std::vector<Eigen::Vector3d> gradient, wanted;
    const MapEntropyTerms terms = ordered.computeGradient(wanted);
    const MapEntropyTerms exact = ordered.computeExact();
    for (auto& cloud : map.clouds)
      std::reverse(cloud->begin(), cloud->end());
    auto reversed = entropyOf(map, settingsFor(directions));
    EXPECT_TRUE(areSame(reversed.computeGradient(gradient), terms));
    EXPECT_EQ(gradient, wanted);
    EXPECT_TRUE(areSame(reversed.computeExact(), exact));
  }
}

TEST(MapEntropyProperties, orderOfObservationsChangesNothing)
{
  PosedClouds map = makeRoomViews(4, 2000, 22);
  const double wanted = entropyOf(map, {}).compute().total;
  const MapEntropyTerms exact = entropyOf(map, {}).computeExact();
  std::reverse(map.clouds.begin(), map.clouds.end());
  std::reverse(map.poses.begin(), map.poses.end());
  EXPECT_NEAR(entropyOf(map, {}).compute().total, wanted, 1e-6);
  EXPECT_NEAR(entropyOf(map, {}).computeExact().total, exact.total, 1e-10);
}

/** Coordinates that remain exact when multiples of the bin size 1/8 are added. */
PosedClouds
makeExactMap()
{
  Random random(23);
  PosedClouds map;
  for (int i = 0; i < 3; ++i) {
    std::vector<Eigen::Vector2d> places;
    for (int p = 0; p < 500; ++p)
      places.emplace_back(std::floor(random.uniform(0, 4096)) / 1024,
                          std::floor(random.uniform(0, 2048)) / 1024);
    map.clouds.push_back(cloudAt(places));
    map.poses.push_back({i / 64.0, -i / 32.0, 0});
  }
  return map;
}

TEST(MapEntropyProperties, translationByWholeBinsChangesNothing)
{
  NaiveEntropySettings settings;
  settings.bin = 0.125;
  PosedClouds map = makeExactMap();
  const MapEntropyTerms exact = entropyOf(map, settings).computeExact();
  const MapEntropyTerms fast = entropyOf(map, settings).compute();
  for (auto& pose : map.poses)
    pose = {pose.x + 37 * 0.125, pose.z - 1013 * 0.125, pose.theta};
  EXPECT_TRUE(areSame(entropyOf(map, settings).computeExact(), exact));
  EXPECT_NEAR(entropyOf(map, settings).compute().total, fast.total, 1e-9);
  map.poses[0].x += 0.03;
  EXPECT_GT(std::abs(entropyOf(map, settings).compute().total - fast.total), 1e-6);
}

TEST(MapEntropyProperties, quarterTurnsSwapTheAxes)
{
  for (const bool directions : {false, true}) {
    PosedClouds map = makeRoomViews(3, 2000, 24);
    const MapEntropyTerms terms = entropyOf(map, settingsFor(directions)).compute();
    for (auto& pose : map.poses) // rotation about the origin: X, Z become Z, -X
      pose = {pose.z, -pose.x, pose.theta + M_PI / 2};
    const MapEntropyTerms turned = entropyOf(map, settingsFor(directions)).compute();
    EXPECT_NEAR(turned.joint, terms.joint, 1e-6);
    EXPECT_NEAR(turned.along_x, terms.along_z, 1e-6);
    EXPECT_NEAR(turned.along_z, terms.along_x, 1e-6);
  }
}

TEST(MapEntropyProperties, threadsChangeNoByte)
{
  const PosedClouds map = makeRoomViews(20, 1000, 25);
  for (const bool directions : {false, true}) {
    auto one = entropyOf(map, settingsFor(directions));
    one.setNumberOfThreads(1);
    std::vector<Eigen::Vector3d> wanted;
    const MapEntropyTerms terms = one.computeGradient(wanted);
    const MapEntropyTerms exact = one.computeExact();
    for (const unsigned threads : {2U, 8U, 0U}) {
      auto entropy = entropyOf(map, settingsFor(directions));
      entropy.setNumberOfThreads(threads);
      std::vector<Eigen::Vector3d> gradient;
      EXPECT_TRUE(areSame(entropy.computeGradient(gradient), terms));
      EXPECT_EQ(gradient, wanted);
      EXPECT_TRUE(areSame(entropy.computeExact(), exact));
    }
  }
}

TEST(MapEntropyProperties, sidesOfNormalsAreTakenFromTheSensor)
{
  PosedClouds map = makeRoomViews(3, 2000, 26);
  const MapEntropyTerms terms = entropyOf(map, settingsFor(true)).compute();
  for (auto& cloud : map.clouds)
    for (PointNormal& point : *cloud)
      point.getNormalVector3fMap() *= -1;
  EXPECT_TRUE(areSame(entropyOf(map, settingsFor(true)).compute(), terms));
}

TEST(MapEntropyProperties, keptCellsAreThoseOfAFreshObject)
{
  const PosedClouds map = makeRoomViews(3, 2000, 27);
  auto entropy = entropyOf(map, {});
  const MapEntropyTerms wanted = entropy.compute();
  entropy.setBinSize(0.31);
  entropy.setDirectionAware(true);
  EXPECT_NE(entropy.compute().total, wanted.total);
  entropy.setPose(1, {0, 0, 0});
  entropy.compute();
  entropy.setBinSize(0.1);
  entropy.setDirectionAware(false);
  entropy.setPose(1, map.poses[1]);
  EXPECT_TRUE(areSame(entropy.compute(), wanted));
  EXPECT_TRUE(areSame(entropy.compute(), wanted)) << "and again, of the same cells";
  entropy.addPointCloud(map.clouds[0], {0, 0, 1});
  EXPECT_EQ(entropy.compute().points, 8000U);
}

TEST(MapEntropyProperties, wallsAlongAnAxisHaveTheLeastProjections)
{
  NaiveEntropySettings settings;
  PosedClouds map = makeThinWall(0);
  for (auto& pose : map.poses)
    pose = {};
  const MapEntropyTerms along = entropyOf(map, settings).compute();
  for (auto& pose : map.poses)
    pose.theta = 0.1;
  const MapEntropyTerms slanted = entropyOf(map, settings).compute();
  EXPECT_LT(along.along_x + along.along_z, slanted.along_x + slanted.along_z);
}

} // namespace
} // namespace pcl::acmap::test
