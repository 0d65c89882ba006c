#include "rectification/rectification_steps.h"
#include "rectification_kernels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr double degree = M_PI / 180;

MapEntropySettings
fine()
{
  MapEntropySettings settings;
  settings.bin_size = 0.05;
  settings.smoothing = 0.05;
  return settings;
}

TEST(BuildingDirection, isFoundWithinATenthOfADegree)
{
  const PosedClouds map = makeRoomViews(4, 4000, 51);
  const auto cells = cellsOf(map, fine());
  for (const double turn : {0.0, 3.3, 17.71, 45.0, 61.4, 88.9, 123.45, -8.2}) {
    const auto poses = turnedMap(map.poses, turn * degree);
    const double found = buildingDirection(cells, poses, fine());
    EXPECT_GE(found, 0);
    EXPECT_LT(found, M_PI / 2);
    EXPECT_NEAR(std::remainder(found / degree + turn, 90), 0, 0.1) << turn;
  }
}

TEST(BuildingDirection, isThatOfACorridorThatTurns)
{
  PosedClouds map = makeCornerWorld(52).truth;
  const auto cells = cellsOf(map, fine());
  const double found =
      buildingDirection(cells, turnedMap(map.poses, 30 * degree), fine());
  EXPECT_NEAR(found / degree, 60, 0.1);
}

TEST(BuildingDirection, ofNothingIsFinite)
{
  const std::vector<EntropyCells> nothing(2);
  const double found = buildingDirection(nothing, {{0, 0, 0}, {1, 1, 1}}, fine());
  EXPECT_GE(found, 0);
  EXPECT_LT(found, M_PI / 2);
}

TEST(TurnedMap, turnsAboutTheOrigin)
{
  const std::vector<PlanarPose> poses{{1, 2, 0.3}, {-4, 5, 3}};
  const auto turned = turnedMap(poses, 0.8);
  for (std::size_t i = 0; i < poses.size(); ++i)
    EXPECT_TRUE(isometryOf(turned[i]).isApprox(
        isometryOf({0, 0, 0.8}) * isometryOf(poses[i]), 1e-12));
  const auto back = turnedMap(turned, -0.8);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_NEAR(back[i].x, poses[i].x, 1e-12);
    EXPECT_NEAR(back[i].z, poses[i].z, 1e-12);
    EXPECT_NEAR(back[i].theta, poses[i].theta, 1e-12);
  }
}

} // namespace
} // namespace pcl::acmap::test
