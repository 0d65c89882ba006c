#include "house_map.h"

#include <pcl/core/fields.h>
#include <pcl/core/surface_sentence.h>
#include <pcl/exceptions.h>
#include <pcl/pipeline/surface_names.h>
#include <pcl/texture/floor_plan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::HasSubstr;

std::string
shownPlane(const CompactMap& map, std::size_t plane)
{
  const SurfaceLabel& label = map.planes[plane].label;
  return std::string(nameIn(surface_role_names, label.role)) + ": " + label.name;
}

const std::vector<std::string> roles_of_house = {
    "floor: Floor of rooms 1 and 2",
    "ceiling: Ceiling of rooms 1 and 2",
    "wall: Wall of room 1",
    "wall: Wall of rooms 1 and 2",
    "wall: Wall of room 2",
    "wall: Wall of rooms 1 and 2",
    "wall: Wall of room 1",
    "wall: Wall of room 2",
    "furniture: Top of furniture in room 1",
    "furniture: Side of furniture in room 1",
    "furniture: Underside of furniture in room 1",
    "furniture: Side of furniture in room 1",
    "door leaf: Door leaf of room 2",
    "wall: Wall of room 2"};

void
expectHouse(const CompactMap& map)
{
  for (std::size_t p = 0; p < roles_of_house.size(); ++p)
    EXPECT_EQ(shownPlane(map, p), roles_of_house[p]) << "plane " << p;
  ASSERT_EQ(map.rooms.size(), 2U);
  EXPECT_EQ(map.rooms[0].label.name, "Room 1");
  EXPECT_NEAR(map.rooms[0].label.size.x(), 5, 0.1);
  EXPECT_NEAR(map.rooms[0].label.size.y(), 4, 0.1);
  std::map<std::string, Vector2d> openings;
  for (const MapOpening& opening : map.openings)
    openings[opening.label.name] = opening.label.size;
  EXPECT_LT((openings["Door between rooms 1 and 2"] - Vector2d(0.9, 2)).norm(), 0.02);
  EXPECT_LT((openings["Window of room 1"] - Vector2d(1.2, 1)).norm(), 0.02);
  EXPECT_LT((map.planes[5].label.size - Vector2d(8.1, 2.6)).norm(), 1e-5);
  EXPECT_LT((map.planes[8].label.size - Vector2d(1.6, 0.8)).norm(), 1e-5);
}

TEST(SurfaceNames, TellWhatPartsOfAHouseAre)
{
  expectHouse(named(makeHouse()));
}

TEST(SurfaceNames, DoNotDependOnTheFrame)
{
  const Eigen::Isometry3d motions[] = {
      Eigen::Translation3d(3, -7, 20) *
          Eigen::AngleAxisd(0.7, Vector3d(1, 2, -0.5).normalized()) *
          Eigen::Isometry3d::Identity(),
      Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX()) * Eigen::Isometry3d::Identity()};
  for (const Eigen::Isometry3d& motion : motions) {
    CompactMap map = makeHouse();
    map.up = motion.linear() * map.up;
    for (PlanePatch& plane : map.planes) {
      plane.center = motion * plane.center;
      plane.axis_u = motion.linear() * plane.axis_u;
      plane.axis_v = motion.linear() * plane.axis_v;
      const Vector3d normal = motion.linear() * plane.coefficients.head<3>();
      plane.coefficients << normal, -normal.dot(plane.center);
      for (PlanePolygon& polygon : plane.polygons) {
        for (Eigen::Vector3f& corner : polygon.outer)
          corner = (motion * corner.cast<double>()).cast<float>();
        for (std::vector<Eigen::Vector3f>& hole : polygon.holes)
          for (Eigen::Vector3f& corner : hole)
            corner = (motion * corner.cast<double>()).cast<float>();
      }
    }
    expectHouse(named(map));
  }
}

TEST(SurfaceNames, OfBoxesRecessesAndCylinders)
{
  CompactMap map = makeHouse();
  BoxPatch box;
  box.center = {2.8, 1.9, 0.42};
  box.size = {1.6, 0.8, 0.64};
  box.faces[4] = {BoxFaceKind::Seen, 8};
  map.boxes = {box};
  RecessPatch door;
  door.center = {0, 1, 1};
  door.size = {0.9, 2, 0.1};
  door.wall = 2;
  addPlane(map, upright({-0.1, 1.45}, {-0.1, 0.55}, 0, 2));
  door.leaf = static_cast<std::int32_t>(map.planes.size()) - 1;
  door.reaches_floor = true;
  map.recesses = {door};
  CylinderPatch column;
  column.axis_point = {4, 3, 1.3};
  column.radius = 0.15;
  column.low = -1.3;
  column.high = 1.3;
  map.cylinders = {column};
  map = named(map);
  EXPECT_EQ(map.boxes[0].name, "Box in room 1");
  EXPECT_EQ(map.recesses[0].name, "Closed door of room 1");
  EXPECT_EQ(map.planes.back().label.role, SurfaceRole::DoorLeaf);
  EXPECT_EQ(map.cylinders[0].label.name, "Column in room 1");
  EXPECT_THAT(describePlane(map, 2), HasSubstr("closed door 0.90 × 2.00 m"));
  EXPECT_EQ(describeCylinder(map, 0),
            "Column in room 1, diameter 0.30 m, 2.60 m long, noise 0.0 mm");
}

TEST(SurfaceNames, ASmallObjectHasNoWalls)
{
  CompactMap map;
  map.up = Vector3d::UnitZ();
  addPlane(map, level({0, 0}, {0.5, 0.4}, 0.3, true));
  addPlane(map, upright({0, 0}, {0.5, 0}, 0, 0.3));
  map = named(map);
  for (std::size_t p = 0; p < map.planes.size(); ++p)
    EXPECT_EQ(shownPlane(map, p), "other: Surface");
}

TEST(SurfaceNames, BadPlanesAreOther)
{
  CompactMap map = makeHouse();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  map.planes[2].polygons[0].outer[1].x() = nan;
  map.planes[3].polygons.clear();
  map.planes[4].coefficients.setConstant(nan);
  map = named(map);
  for (const std::size_t p : {2U, 3U, 4U})
    EXPECT_EQ(map.planes[p].label.role, SurfaceRole::Other) << p;
  CompactMap empty;
  empty = named(empty);
  EXPECT_TRUE(empty.rooms.empty());
}

TEST(SurfaceSentence, SaysWhatOneSees)
{
  const CompactMap map = named(makeHouse());
  EXPECT_EQ(describePlane(map, 6),
            "Wall of room 1, 8.6 m², 4.0 × 2.6 m, door 0.90 × 2.00 m, noise 6.8 mm");
  EXPECT_THAT(describePlane(map, 5), HasSubstr("window 1.20 × 1.00 m"));
  EXPECT_THAT(describeRoom(map, 0), HasSubstr(" m, 1 door, 1 window"));
  EXPECT_THROW(describePlane(map, 99), BadArgumentException);
  CompactMap unnamed = makeHouse();
  unnamed.planes[0].rms = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(describePlane(unnamed, 0), "Plane 0, 32.4 m²");
}

} // namespace
} // namespace pcl::acmap::test
