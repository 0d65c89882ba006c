#include <pcl/core/plane_distance.h>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;

/** A rectangle upright to the x axis, from y and z 0. */
PlanePatch
makeWall(double x, double width, double height, double facing)
{
  PlanePatch wall;
  wall.coefficients << facing, 0, 0, -facing * x;
  wall.center = {x, width / 2, height / 2};
  wall.axis_u = Vector3d::UnitY();
  wall.axis_v = facing * Vector3d::UnitZ();
  wall.covariance = Vector3d(1e-8, 4e-8, 1e-6).asDiagonal();
  const auto corner = [&](double y, double z) {
    return Vector3d(x, y, z).cast<float>().eval();
  };
  wall.polygons = {
      {{corner(0, 0), corner(width, 0), corner(width, height), corner(0, height)}, {}}};
  return wall;
}

/** Two walls 3 m apart; the one is 4 m wide, the other one 8 m. */
CompactMap
makeCorridor()
{
  CompactMap map;
  map.planes = {makeWall(1, 4, 2, 1), makeWall(4, 8, 2, -1)};
  return map;
}

void
addPoses(CompactMap& map, std::initializer_list<double> places)
{
  for (const double y : places) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Vector3d(2, y, 1);
    map.trajectory.stamps.push_back(y);
    map.trajectory.poses.push_back(pose);
  }
}

TEST(PlaneDistance, IsMeasuredAtTheMiddleOfTheOverlap)
{
  const PlaneDistance found = distanceBetween(makeCorridor(), 0, 1);
  EXPECT_NEAR(found.distance, 3, 1e-6);
  EXPECT_LT((found.place - Vector3d(1, 2, 1)).norm(), 1e-6);
  EXPECT_TRUE(found.is_at_least);
  // the middle is 2 m from the centre of the second wall, along its axis_u
  EXPECT_NEAR(found.deviation, std::sqrt(1e-6 + 1e-6 + 4 * 1e-8), 1e-9);
  EXPECT_NEAR(distanceBetween(makeCorridor(), 1, 0).distance, 3, 1e-6);
}

TEST(PlaneDistance, SharedPosesCancel)
{
  CompactMap map = makeCorridor();
  addPoses(map, {0, 1, 2, 3});
  map.accuracy = {0.01, 0.002};
  const double noise = 1e-6 + 1e-6 + 4 * 1e-8;
  const auto variance = [&](std::vector<std::int32_t> a, std::vector<std::int32_t> b) {
    CompactMap of = map;
    of.observations = {std::move(a), std::move(b)};
    for (std::size_t p = 0; p < 2; ++p)
      of.planes[p].covariance(2, 2) += poseVariance(of, p);
    const PlaneDistance found = distanceBetween(of, 0, 1);
    EXPECT_FALSE(found.is_at_least);
    return found.deviation * found.deviation;
  };
  EXPECT_NEAR(variance({0, 1, 2, 3}, {0, 1, 2, 3}), noise, 1e-12);
  // from places 2 m apart: two poses each, and the drift between their middles
  EXPECT_NEAR(variance({0, 1}, {2, 3}), noise + 2 * 1e-4 / 2 + 4e-6 * 4, 1e-12);
  EXPECT_NEAR(variance({0, 1}, {1}), noise + 1e-4 / 2 + 4e-6 / 4, 1e-12);
  map.accuracy.scale = 0.001;
  EXPECT_NEAR(variance({0}, {0}), noise + 9e-6, 1e-12);
}

TEST(PlaneDistance, NeedsParallelPlanes)
{
  CompactMap map = makeCorridor();
  map.planes[1].coefficients << 0, 1, 0, 0;
  EXPECT_THROW(distanceBetween(map, 0, 1), BadArgumentException);
  EXPECT_THROW(distanceBetween(map, 0, 7), BadArgumentException);
  map = makeCorridor();
  map.planes[0].polygons.clear();
  EXPECT_THROW(distanceBetween(map, 0, 1), BadArgumentException);
  map = makeCorridor();
  map.planes[0].covariance.setConstant(NAN);
  EXPECT_TRUE(std::isnan(distanceBetween(map, 0, 1).deviation));
}

} // namespace
} // namespace pcl::acmap::test
