#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/map_up.h>

#include <pcl/core/random.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/** A rectangle with a given centre. */
PlanePatch
plateOf(const Vector3d& center, const Vector3d& u, const Vector3d& v)
{
  PlanePatch plane;
  const Vector3d normal = u.cross(v).normalized();
  plane.coefficients << normal, -normal.dot(center);
  plane.area = 4 * u.norm() * v.norm();
  PlanePolygon polygon;
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    polygon.outer.push_back((center + a * u + b * v).cast<float>());
  plane.polygons = {polygon};
  return plane;
}

/** Floor, ceiling and four walls, 6 m wide, 2.6 m high and 4 m deep, in the frame of a
 * rotated camera. */
CompactMap
roomSeenBy(const Quaterniond& T_camera_room)
{
  const Vector3d x(3, 0, 0), y(0, 1.3, 0), z(0, 0, 2);
  CompactMap map;
  for (const auto& [center, u, v] : {std::tuple{y, z, x},
                                     {Vector3d(-y), x, z},
                                     {z, x, y},
                                     {Vector3d(-z), y, x},
                                     {x, y, z},
                                     {Vector3d(-x), z, y}})
    map.planes.push_back(
        plateOf(T_camera_room * center, T_camera_room * u, T_camera_room * v));
  return map;
}

Quaterniond
turnedAbout(const Vector3d& axis, double degrees)
{
  return Quaterniond(AngleAxisd(degrees * M_PI / 180, axis));
}

const Vector3d up = -Vector3d::UnitY(); // of a room, and of a horizontal camera

TEST(MapUp, ALevelMapHasItsOwnAxis)
{
  CompactMap map = roomSeenBy(Quaterniond::Identity());
  EXPECT_EQ(upAxis(map), up);
  EXPECT_EQ(upDirection(map), up);
  map = roomSeenBy(turnedAbout(Vector3d::UnitZ(), 0.3));
  EXPECT_EQ(upDirection(map), up) << "planes are not as exact as a robot's camera";
}

TEST(MapUp, TheDirectionOfTheMapIsTakenIfItIsKnown)
{
  CompactMap map = roomSeenBy(turnedAbout(Vector3d::UnitX(), 20));
  map.trajectory.poses.assign(2, Eigen::Isometry3d::Identity());
  map.up = Vector3d::UnitZ();
  EXPECT_EQ(upAxis(map), map.up);
  EXPECT_EQ(upDirection(map), map.up);
  map.up = Vector3d(0.1, -1, 0).normalized();
  EXPECT_EQ(upAxis(map), up);
  EXPECT_TRUE(upDirection(map).isApprox(map.up, 1e-15));
}

TEST(MapUp, ATiltedCameraIsSeenFromThePlanes)
{
  for (const double pitch : {-40.0, -20.0, 1.5, 30.0})
    for (const double roll : {-10.0, 0.0, 10.0}) {
      const Quaterniond tilt =
          turnedAbout(Vector3d::UnitX(), pitch) * turnedAbout(Vector3d::UnitZ(), roll);
      CompactMap map = roomSeenBy(tilt * turnedAbout(Vector3d::UnitY(), 25));
      EXPECT_LT((upDirection(map) - tilt * up).norm(), 1e-4) << pitch << " " << roll;
      EXPECT_EQ(upAxis(map), up);
      map.trajectory.poses.assign(2, Eigen::Isometry3d::Identity());
      EXPECT_LT((upDirection(map) - tilt * up).norm(), 1e-4) << pitch << " " << roll;
    }
}

TEST(MapUp, OtherCamerasTellWhereTheFirstOneIsTiltedMuch)
{
  // when tilted by 55 degrees, a wall normal is closer to up than that of the ceiling
  const Quaterniond tilt = turnedAbout(Vector3d::UnitX(), 55);
  CompactMap map = roomSeenBy(tilt);
  map.trajectory.poses.assign(6, Eigen::Isometry3d(tilt));
  map.trajectory.poses[0] = Eigen::Isometry3d::Identity();
  EXPECT_LT((upDirection(map) - tilt * up).norm(), 1e-5);
}

TEST(MapUp, OnePlaneTellsWhatItCan)
{
  const Quaterniond tilt = turnedAbout(Vector3d::UnitX(), 35);
  const CompactMap room = roomSeenBy(tilt);
  CompactMap desk, wall;
  desk.planes = {room.planes[0]};
  EXPECT_LT((upDirection(desk) - tilt * up).norm(), 1e-6);
  wall.planes = {room.planes[2]};
  EXPECT_NEAR(upDirection(wall).dot(wall.planes[0].coefficients.head<3>()), 0, 1e-3);
  EXPECT_LT((upDirection(wall) - tilt * up).norm(), 0.01) << "nearest to the camera's";
}

TEST(MapUp, SmallPlanesAndClutterDoNotMatter)
{
  const Quaterniond tilt = turnedAbout(Vector3d::UnitX(), -25);
  CompactMap map = roomSeenBy(tilt);
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    const Vector3d normal =
        Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    const Vector3d u = 0.3 * normal.unitOrthogonal();
    map.planes.push_back(plateOf(Vector3d::Zero(), u, normal.cross(u)));
  }
  EXPECT_LT((upDirection(map) - tilt * up).norm(), 0.01);
  map.planes.erase(map.planes.begin(), map.planes.begin() + 6);
  EXPECT_EQ(upDirection(map), up) << "of clutter alone nothing is up";
}

TEST(MapUp, ScannersHaveZUp)
{
  const Quaterniond turn = smallestRotation(up, Vector3d::UnitZ());
  EXPECT_EQ(upAxis(roomSeenBy(turn)), Vector3d::UnitZ());
  const Quaterniond tilt = turnedAbout(Vector3d::UnitX(), 6);
  EXPECT_LT((upDirection(roomSeenBy(tilt * turn)) - tilt * Vector3d::UnitZ()).norm(),
            1e-5);
}

TEST(MapUp, CamerasComeFirst)
{
  CompactMap map = roomSeenBy(Quaterniond::Identity());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.rotate(AngleAxisd(3, Vector3d::UnitX()));
  map.trajectory.poses = {pose};
  EXPECT_EQ(upAxis(map), Vector3d::UnitY()) << "the camera stands on its head";
  EXPECT_EQ(upDirection(map), Vector3d::UnitY());
  map.trajectory.poses[0].matrix().fill(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(upAxis(map), up) << "as without";
}

TEST(MapUp, WithoutPlanesItIsTheCameras)
{
  EXPECT_EQ(upAxis({}), up);
  EXPECT_EQ(upDirection({}), up);
  CompactMap map = roomSeenBy(turnedAbout(Vector3d::UnitX(), 20));
  map.planes[0].coefficients.fill(std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 1; i < map.planes.size(); ++i)
    map.planes[i].area = 0;
  EXPECT_EQ(upDirection(map), up);
}

} // namespace
} // namespace pcl::acmap::test
