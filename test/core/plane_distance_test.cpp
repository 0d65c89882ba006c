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

TEST(PlaneDistance, CommonErrorsCancel)
{
  const double noise = 1e-6 + 1e-6 + 4 * 1e-8;
  const auto variance = [&](const std::vector<Vector3d>& a,
                            const std::vector<Vector3d>& b) {
    CompactMap map = makeCorridor();
    map.planes[0].pose_modes = a;
    map.planes[1].pose_modes = b;
    for (PlanePatch& plane : map.planes)
      for (const Vector3d& mode : plane.pose_modes)
        plane.covariance += mode * mode.transpose();
    const PlaneDistance found = distanceBetween(map, 0, 1);
    EXPECT_EQ(found.is_at_least, a.empty() || b.empty());
    EXPECT_NEAR(distanceBetween(map, 1, 0).deviation, found.deviation, 1e-9);
    return found.deviation * found.deviation;
  };
  EXPECT_NEAR(variance({}, {}), noise, 1e-12);
  // both move along x: the normals are opposite, and so are the offsets
  EXPECT_NEAR(variance({{0, 0, 0.01}}, {{0, 0, -0.01}}), noise, 1e-12);
  EXPECT_NEAR(variance({{0, 0, 0.01}}, {{0, 0, 0.01}}), noise + 4e-4, 1e-12);
  // of independent errors
  EXPECT_NEAR(variance({{0, 0, 0.01}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0.02}}),
              noise + 1e-4 + 4e-4,
              1e-12);
  // the middle is 2 m from the centre of the second wall, at -2 along its axis_u
  EXPECT_NEAR(variance({{0, 0, 0}}, {{0.001, 0, 0}}), noise + 4e-6, 1e-12);
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
