#include "room_map.h"

#include <pcl/core/surface_sentence.h>
#include <pcl/exceptions.h>
#include <pcl/visualization/plane_card.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;

void
expectLine(const std::string& card, const std::string& line)
{
  EXPECT_NE(card.find(line + "\n"), std::string::npos) << line << " in\n" << card;
}

TEST(PlaneCard, TellsWhatIsKnown)
{
  CompactMap map = makeRoomMap();
  map.planes[1].effective_support = 250;
  map.planes[1].label.name = "Wall of room 2";
  const std::string card = planeCard(map, 1);
  EXPECT_EQ(card.substr(0, card.find('\n')), describePlane(map, 1));
  EXPECT_EQ(card.substr(0, 14), "Wall of room 2");
  expectLine(card, "plane 1");
  expectLine(card, "equation   -1.00000 x +0.00000 y +0.00000 z +3.0000 = 0");
  expectLine(card, "deviation  slopes 0.0573 deg and 0.115 deg, offset 3 mm");
  expectLine(card, "support    1000 points, 250 of them independent");
  EXPECT_THROW(planeCard(map, 6), BadArgumentException);
}

TEST(PlaneCard, SaysWhatIsNotKnown)
{
  CompactMap map;
  PlanePatch& plane = map.planes.emplace_back();
  plane.covariance.setConstant(NAN);
  plane.covariance(1, 1) = -1; // not a valid variance
  plane.area = NAN;
  plane.rms = INFINITY;
  const std::string card = planeCard(map, 0);
  expectLine(card, "deviation  slopes unknown and unknown, offset unknown");
  expectLine(card, "support    0 points");
}

TEST(CylinderCard, TellsWhatIsKnown)
{
  CompactMap map;
  CylinderPatch& cylinder = map.cylinders.emplace_back();
  cylinder.radius = 0.25;
  cylinder.low = -1;
  cylinder.high = 1.5;
  cylinder.arc = M_PI;
  cylinder.covariance(4, 4) = 4e-6;
  cylinder.support = 1000;
  cylinder.rms = 0.004;
  cylinder.area = 1.963;
  cylinder.saved_bits = 1234.4;
  const std::string card = cylinderCard(map, 0);
  expectLine(card, describeCylinder(map, 0));
  expectLine(card, "cylinder 0, solid");
  expectLine(card, "radius     0.2500 m, deviation 2 mm");
  expectLine(card, "extent     2.500 m, 180 deg of arc");
  expectLine(card, "support    1000 points");
  expectLine(card, "area       1.963 m2");
  expectLine(card, "saved      1234 bits");
  cylinder.is_hollow = true;
  cylinder.covariance.setConstant(NAN);
  expectLine(cylinderCard(map, 0), "cylinder 0, hollow");
  expectLine(cylinderCard(map, 0), "radius     0.2500 m, deviation unknown");
}

TEST(RecessCard, TellsWhatIsKnown)
{
  RecessPatch recess;
  recess.size = {0.9, 2.1, 0.1};
  recess.wall = 3;
  recess.leaf = 7;
  recess.reaches_floor = true;
  recess.covariance.diagonal().tail<3>() << 4e-6, 9e-6, NAN;
  recess.template_id = 2;
  recess.saved_bits = 12.4;
  const std::string card = recessCard(recess, 5);
  expectLine(card, "recess 5, template 2");
  expectLine(card, "width      0.900 m (deviation 2 mm)");
  expectLine(card, "height     2.100 m (deviation 3 mm)");
  expectLine(card, "depth      0.100 m (deviation unknown)");
  expectLine(card, "planes     7 behind 3, down to the floor");
  expectLine(card, "saved      12 bits");
  recess.reaches_floor = false;
  expectLine(recessCard(recess, 5), "planes     7 behind 3, above the floor");
}

TEST(PlaneOnRay, FindsNothingBehindACylinder)
{
  CompactMap map = makeRoomMap();
  CylinderPatch column;
  column.axis_point = {0, 0, 1};
  column.axis_direction = Vector3d::UnitY();
  column.axis_u = -Vector3d::UnitZ();
  column.axis_v = -Vector3d::UnitX();
  column.radius = 0.2;
  column.low = -0.5;
  column.high = 0.5;
  column.arc = M_PI;
  map.cylinders.push_back(column);
  EXPECT_EQ(planeOnRay(map, Vector3d::Zero(), Vector3d::UnitZ()), std::nullopt);
  EXPECT_EQ(planeOnRay(map, {0.3, 0, 0}, Vector3d::UnitZ()), 0u);
}

TEST(PlaneOnRay, MeetsTheFirstPlane)
{
  const CompactMap map = makeRoomMap();
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  EXPECT_EQ(planeOnRay(map, Vector3d::Zero(), z), 0u);
  EXPECT_EQ(planeOnRay(map, Vector3d::Zero(), 1e-3 * x), 1u);
  EXPECT_EQ(planeOnRay(map, Vector3d::Zero(), -z), 2u);
  EXPECT_EQ(planeOnRay(map, Vector3d(0, 1, 1.8), -x), 3u);
  EXPECT_EQ(planeOnRay(map, Vector3d::Zero(), y), 4u);
  EXPECT_EQ(planeOnRay(map, Vector3d::Zero(), -y), 5u);
}

TEST(PlaneOnRay, PassesThroughDoorsWindowsAndBacks)
{
  const CompactMap map = makeRoomMap();
  EXPECT_EQ(planeOnRay(map, {1.5, 0, 0}, Vector3d::UnitZ()), std::nullopt) << "door";
  EXPECT_EQ(planeOnRay(map, Vector3d::Zero(), -Vector3d::UnitX()), std::nullopt)
      << "window";
  const Vector3d above(0, -10, 0);
  EXPECT_EQ(planeOnRay(map, above, Vector3d::UnitY()), 5u);
  EXPECT_EQ(planeOnRay(map, above, Vector3d::UnitY(), true), 4u);
  EXPECT_EQ(planeOnRay(map, above, -Vector3d::UnitY()), std::nullopt);
  EXPECT_EQ(planeOnRay({}, above, Vector3d::UnitY()), std::nullopt);
}

TEST(PlaneOnRay, RefusesRaysThatAreNone)
{
  const CompactMap map = makeRoomMap();
  const Vector3d nan = Vector3d::Constant(NAN);
  EXPECT_THROW(planeOnRay(map, nan, Vector3d::UnitX()), BadArgumentException);
  EXPECT_THROW(planeOnRay(map, Vector3d::Zero(), nan), BadArgumentException);
  EXPECT_THROW(planeOnRay(map, Vector3d::Zero(), Vector3d::Zero()),
               BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
