#include "temporary_folder.h"

#include <pcl/core/image_file.h>
#include <pcl/texture/floor_plan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <limits>
#include <numeric>
#include <sstream>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3f;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Loop = std::vector<Vector3f>;

/** A plane with one polygon; its area is that of the outer loop. */
PlanePatch
makePlane(const Vector3f& normal,
          const Loop& outer,
          const std::vector<Loop>& holes = {})
{
  PlanePatch plane;
  plane.coefficients << normal.cast<double>(),
      -normal.cast<double>().dot(outer.front().cast<double>());
  plane.polygons.push_back({outer, holes});
  Vector3f twice = Vector3f::Zero();
  for (std::size_t k = 0; k < outer.size(); ++k)
    twice += outer[k].cross(outer[(k + 1) % outer.size()]);
  plane.area = 0.5 * std::abs(twice.dot(normal));
  return plane;
}

/** Two rooms of 4 x 3 m and 2 x 3 m, 2.6 m high, floor at y = 1, y down: the wall
 * between them, 0.1 m thick and seen from both sides, has a door of 0.9 x 2 m; the far
 * wall of the larger one has a window of 1.2 x 1 m. */
CompactMap
makeRooms()
{
  const float low = 1, high = -1.6F;
  const auto upright = [&](float x0, float z0, float x1, float z1) {
    return Loop{{x0, low, z0}, {x1, low, z1}, {x1, high, z1}, {x0, high, z0}};
  };
  const auto partition = [&](float x, const Vector3f& normal) {
    return makePlane(normal,
                     {{x, low, 0},
                      {x, low, 1},
                      {x, -1, 1},
                      {x, -1, 1.9F},
                      {x, low, 1.9F},
                      {x, low, 3},
                      {x, high, 3},
                      {x, high, 0}});
  };
  CompactMap map;
  map.planes = {
      makePlane(-Vector3f::UnitY(),
                {{0, low, 0}, {6.1F, low, 0}, {6.1F, low, 3}, {0, low, 3}},
                {{{1, low, 1}, {1, low, 2}, {2, low, 2}, {2, low, 1}}}),
      makePlane(Vector3f::UnitY(),
                {{0, high, 0}, {0, high, 3}, {6.1F, high, 3}, {6.1F, high, 0}}),
      makePlane(Vector3f::UnitX(), upright(0, 0, 0, 3)),
      makePlane(-Vector3f::UnitX(), upright(6.1F, 3, 6.1F, 0)),
      makePlane(Vector3f::UnitZ(), upright(6.1F, 0, 0, 0)),
      makePlane(-Vector3f::UnitZ(),
                upright(0, 3, 6.1F, 3),
                {{{1, 0, 3}, {1, -1, 3}, {2.2F, -1, 3}, {2.2F, 0, 3}}}),
      partition(4, -Vector3f::UnitX()),
      partition(4.1F, Vector3f::UnitX())};
  return map;
}

double
lengthOf(const PlanOpening& opening)
{
  return (opening.to - opening.from).norm();
}

double
lengthOf(const std::vector<PlanWall>& walls)
{
  return std::accumulate(
      walls.begin(), walls.end(), 0.0, [](double sum, const PlanWall& wall) {
        return sum + (wall.to - wall.from).norm();
      });
}

/** The planes around both rooms, and what their openings lead to. */
void
expectGraph(const FloorPlan& plan)
{
  EXPECT_THAT(plan.rooms[0].planes, ElementsAre(0, 1, 2, 4, 5, 6));
  EXPECT_THAT(plan.rooms[1].planes, ElementsAre(0, 1, 3, 4, 5, 7));
  EXPECT_THAT(plan.openings[0].rooms, ElementsAre(0, -1));
  EXPECT_THAT(plan.openings[1].rooms, ElementsAre(0, 1));
  EXPECT_THAT(plan.openings[2].rooms, ElementsAre(1, 0));
  EXPECT_NEAR(plan.openings[0].bottom, 1, 1e-5);
  EXPECT_NEAR(plan.openings[0].top, 2, 1e-5);
  EXPECT_EQ(plan.openings[1].bottom, 0);
  EXPECT_NEAR(plan.openings[1].top, 2, 1e-5);
}

double
areaOf(const std::vector<Eigen::Vector2d>& loop)
{
  double twice = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Eigen::Vector2d &a = loop[k], &b = loop[(k + 1) % loop.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

void
expectRooms(const FloorPlan& plan)
{
  // the whole floor was seen but for a square metre, which the larger room encloses
  ASSERT_EQ(plan.rooms.size(), 2U);
  EXPECT_NEAR(plan.rooms[0].area, 12, 0.15);
  EXPECT_NEAR(plan.rooms[0].seen_area, 11, 0.15);
  EXPECT_NEAR(plan.rooms[1].area, 6, 0.15);
  EXPECT_NEAR(plan.rooms[1].seen_area, 6, 0.15);
  for (const PlanRoom& room : plan.rooms) {
    EXPECT_NEAR(areaOf(room.outline), room.area, 0.3); // counter-clockwise
    EXPECT_GE(room.outline.size(), 4U);
    EXPECT_LE(room.outline.size(), 8U);
  }
  ASSERT_EQ(plan.openings.size(), 3U); // the window, and the door on both sides
  EXPECT_NEAR(lengthOf(plan.openings[0]), 1.2, 1e-5);
  EXPECT_TRUE(plan.openings[0].is_window);
  EXPECT_EQ(plan.openings[0].plane, 5U);
  for (const std::size_t door : {1U, 2U}) {
    EXPECT_NEAR(lengthOf(plan.openings[door]), 0.9, 1e-5);
    EXPECT_FALSE(plan.openings[door].is_window);
    EXPECT_EQ(plan.openings[door].plane, 5 + door);
  }
  expectGraph(plan);
  EXPECT_EQ(plan.walls.size(), 9U);
  EXPECT_NEAR(lengthOf(plan.walls), 2 * 6.1 + 4 * 3 - 1.2 - 2 * 0.9, 1e-4);
}

TEST(FloorPlan, ShowsWallsOpeningsAndRooms)
{
  const FloorPlan plan = makeFloorPlan(makeRooms());
  expectRooms(plan);
  EXPECT_TRUE(plan.up.isApprox(-Eigen::Vector3d::UnitY(), 1e-9));
  EXPECT_TRUE(plan.y_axis.isApprox(Eigen::Vector3d::UnitZ(), 1e-9));
  EXPECT_NEAR(plan.floor, -1, 1e-6);
  EXPECT_NEAR(plan.cut, 0.5, 1e-6);
  EXPECT_GT(plan.rooms[0].center.x(), 0);
  EXPECT_LT(plan.rooms[0].center.x(), 4);
  EXPECT_GT(plan.rooms[1].center.x(), 4.1);
  // seen from the left: the wall at x = 0 is seen from the side of larger x
  for (const PlanWall& wall : plan.walls)
    if (wall.plane == 2) {
      EXPECT_GT(wall.from.y(), wall.to.y());
    }
}

/** More may be seen of a table, or of all worktops of a kitchen, than of the floor. */
TEST(FloorPlan, WallsEncloseTheFloorThatWasNotSeen)
{
  CompactMap map = makeRooms();
  map.planes.erase(map.planes.begin() + 6, map.planes.end()); // the partition
  const auto strip = [](float x0, float x1) {
    return Loop{{x0, 1, 0.5F}, {x1, 1, 0.5F}, {x1, 1, 2.5F}, {x0, 1, 2.5F}};
  };
  PlanePatch& floor = map.planes[0];
  floor.polygons = {{strip(0.5F, 1.5F), {}}, {strip(4.5F, 5.5F), {}}};
  floor.area = 4;
  const FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.rooms.size(), 1U);
  EXPECT_NEAR(plan.rooms[0].area, 6.1 * 3, 0.5);
  EXPECT_NEAR(plan.rooms[0].seen_area, 4, 0.1);
  map.planes.erase(map.planes.begin() + 3); // a wall: nothing encloses them any more
  EXPECT_EQ(makeFloorPlan(map).rooms.size(), 2U);
}

/** The pavement of a facade is no room. */
TEST(FloorPlan, OneWallEnclosesNoRoom)
{
  CompactMap map = makeRooms();
  map.planes.resize(6);                     // without the partition
  map.planes.erase(map.planes.begin() + 1); // nor the ceiling
  const CompactMap room = map;
  map.planes.resize(1);
  EXPECT_TRUE(makeFloorPlan(map).rooms.empty());
  map.planes.push_back(room.planes[3]); // along the longer side
  const FloorPlan facade = makeFloorPlan(map);
  EXPECT_TRUE(facade.rooms.empty());
  EXPECT_FALSE(facade.floors.empty());
  map.planes.push_back(room.planes[1]);
  map.planes.push_back(room.planes[2]);
  EXPECT_EQ(makeFloorPlan(map).rooms.size(), 1U);
  map.planes = {room.planes[0], makeRooms().planes[1]}; // below a ceiling
  EXPECT_EQ(makeFloorPlan(map).rooms.size(), 1U);
}

TEST(FloorPlan, FloorIsBelowLargerTables)
{
  CompactMap map = makeRooms();
  const float table = 0.1F;
  map.planes.push_back(makePlane(
      -Vector3f::UnitY(),
      {{0, table, 0}, {6.1F, table, 0}, {6.1F, table, 3.5F}, {0, table, 3.5F}}));
  ASSERT_GT(map.planes.back().area, map.planes[0].area);
  expectRooms(makeFloorPlan(map));
  const float pedestal = 1.5F; // a level that is small is not the floor
  map.planes.push_back(makePlane(
      -Vector3f::UnitY(), {{8, pedestal, 0}, {10, pedestal, 0}, {10, pedestal, 2}}));
  expectRooms(makeFloorPlan(map));
}

/** Where a wall was only partly seen, the end of what was seen is not level. */
TEST(FloorPlan, RaggedGapsAreNoWindows)
{
  CompactMap map = makeRooms();
  map.planes[5].polygons[0].holes[0][3].y() = 0.6F; // a corner of the window's sill
  FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.openings.size(), 2U);
  for (const PlanOpening& door : plan.openings)
    EXPECT_FALSE(door.is_window);
  map = makeRooms();
  map.planes[5].polygons[0].holes[0][1].y() = -1.4F; // a corner of its lintel
  EXPECT_EQ(makeFloorPlan(map).openings.size(), 2U);
}

/** The partition of makeRooms with its door in the corner, at z = 3 or z = 0.
 * \param[in] gap metres at the end of the far wall that were not seen */
CompactMap
makeRoomsWithCornerDoor(bool is_far, float gap)
{
  CompactMap map = makeRooms();
  for (const std::size_t plane : {6U, 7U}) {
    const float x = map.planes[plane].polygons[0].outer[0].x();
    Loop& outer = map.planes[plane].polygons[0].outer;
    outer = {
        {x, 1, 0}, {x, 1, 2}, {x, -1, 2}, {x, -1, 3}, {x, -1.6F, 3}, {x, -1.6F, 0}};
    if (!is_far)
      for (Vector3f& place : outer)
        place.z() = 3 - place.z();
  }
  for (Vector3f& place : map.planes[5].polygons[0].outer)
    place.x() -= place.x() > 6 ? gap : 0;
  return map;
}

TEST(FloorPlan, FindsDoorsInCorners)
{
  for (const bool is_far : {true, false}) {
    const FloorPlan plan = makeFloorPlan(makeRoomsWithCornerDoor(is_far, 0));
    ASSERT_EQ(plan.rooms.size(), 2U);
    EXPECT_NEAR(plan.rooms[0].area, 12, 0.15);
    ASSERT_EQ(plan.openings.size(), 3U);
    for (const std::size_t door : {1U, 2U}) {
      EXPECT_NEAR(lengthOf(plan.openings[door]), 1, 1e-5);
      EXPECT_FALSE(plan.openings[door].is_window);
      EXPECT_EQ(plan.openings[door].plane, 5 + door);
      EXPECT_NEAR(plan.openings[door].top, 2, 1e-5);
      EXPECT_THAT(plan.openings[door].rooms, ElementsAre(door - 1, 2 - door));
    }
  }
}

/** Without the wall that the opening reaches to, nothing tells how wide it is. */
TEST(FloorPlan, DoesNotInventTheEndOfAnOpening)
{
  const FloorPlan plan = makeFloorPlan(makeRoomsWithCornerDoor(true, 3));
  ASSERT_EQ(plan.openings.size(), 1U);
  EXPECT_TRUE(plan.openings[0].is_window);
}

/** Moves a map. */
CompactMap
moved(CompactMap map, const Eigen::Isometry3d& T_out_map)
{
  const auto move = [&](Loop& loop) {
    for (Vector3f& place : loop)
      place = (T_out_map * place.cast<double>()).cast<float>();
  };
  for (PlanePatch& plane : map.planes) {
    const Eigen::Vector3d normal = T_out_map.linear() * plane.coefficients.head<3>();
    plane.coefficients << normal,
        plane.coefficients[3] - normal.dot(T_out_map.translation());
    for (PlanePolygon& polygon : plane.polygons) {
      move(polygon.outer);
      for (Loop& hole : polygon.holes)
        move(hole);
    }
  }
  return map;
}

/** The same rooms in the frame of a scanner, z up, far from the origin. */
TEST(FloorPlan, IsDrawnAlongTheFloorOfAnyFrame)
{
  Eigen::Isometry3d T_out_map(Eigen::Translation3d(100, -50, 7));
  T_out_map.rotate(Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitX()));
  const FloorPlan plan = makeFloorPlan(moved(makeRooms(), T_out_map));
  EXPECT_TRUE(plan.up.isApprox(Eigen::Vector3d::UnitZ(), 1e-9));
  ASSERT_EQ(plan.rooms.size(), 2U);
  EXPECT_NEAR(plan.rooms[0].area, 12, 0.15);
  EXPECT_EQ(plan.openings.size(), 3U);
}

TEST(FloorPlan, IsAlignedWithTheWalls)
{
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitY()));
  const FloorPlan plan = makeFloorPlan(moved(makeRooms(), turn));
  expectRooms(plan);
  for (const PlanWall& wall : plan.walls)
    EXPECT_NEAR((wall.to - wall.from).cwiseAbs().minCoeff(), 0, 1e-5);
  EXPECT_GT(plan.x_axis.x(), 0.8);
  EXPECT_TRUE(plan.y_axis.isApprox(plan.up.cross(plan.x_axis), 1e-9));
}

TEST(FloorPlan, KeepsTheGridOfAShiftedMap)
{
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitY()));
  CompactMap map = moved(makeRooms(), turn);
  map.shift << 1000, 0, 5000;
  const FloorPlan plan = makeFloorPlan(map);
  expectRooms(plan);
  EXPECT_EQ(plan.shift, map.shift);
  EXPECT_EQ(plan.x_axis, Eigen::Vector3d(Eigen::Vector3d::UnitX()));
  EXPECT_EQ(plan.up, Eigen::Vector3d(-Eigen::Vector3d::UnitY()));
}

/** A cupboard hides a part of the wall, so that the wall has a gap at the section. */
TEST(FloorPlan, BecomesTheGraphOfTheMap)
{
  CompactMap map = makeRooms();
  setRooms(makeFloorPlan(map), map);
  ASSERT_EQ(map.rooms.size(), 2U);
  EXPECT_NEAR(map.rooms[0].area, 12, 0.15);
  EXPECT_NEAR(map.rooms[0].seen_area, 11, 0.15);
  EXPECT_THAT(map.rooms[1].planes, ElementsAre(0, 1, 3, 4, 5, 7));
  for (const MapRoom& room : map.rooms)
    EXPECT_NEAR(room.center.y(), 1, 1e-6);
  EXPECT_GT(map.rooms[1].center.x(), 4.1);
  EXPECT_THAT(map.rooms[0].openings, ElementsAre(0, 1));
  EXPECT_THAT(map.rooms[1].openings, ElementsAre(1));
  ASSERT_EQ(map.openings.size(), 2U); // the door once
  EXPECT_EQ(map.openings[0].kind, OpeningKind::Window);
  EXPECT_THAT(map.openings[0].planes, ElementsAre(5, -1));
  EXPECT_THAT(map.openings[0].rooms, ElementsAre(0, -1));
  const MapOpening& door = map.openings[1];
  EXPECT_EQ(door.kind, OpeningKind::Door);
  EXPECT_THAT(door.planes, ElementsAre(6, 7));
  EXPECT_THAT(door.rooms, ElementsAre(0, 1));
  EXPECT_NEAR(door.top, 2, 1e-5);
  EXPECT_LT((door.from - Eigen::Vector3d(4, 1, 1)).norm(), 1e-5);
  EXPECT_LT((door.to - Eigen::Vector3d(4, 1, 1.9)).norm(), 1e-5);
  setRooms(makeFloorPlan(map), map);
  EXPECT_EQ(map.openings.size(), 2U);
  setRooms({}, map);
  EXPECT_THAT(map.rooms, IsEmpty());
  EXPECT_THAT(map.openings, IsEmpty());
}

/** With a leaf in the doorway, one cannot look through it from either side. */
TEST(FloorPlan, ClosedDoorsJoinTheRoomsOfTheirFaces)
{
  CompactMap map = makeRooms();
  for (const auto& [x, normal] : {std::pair{4.04F, -1.0F}, {4.06F, 1.0F}})
    map.planes.push_back(
        makePlane(normal * Vector3f::UnitX(),
                  {{x, 1, 1}, {x, 1, 1.9F}, {x, -1, 1.9F}, {x, -1, 1}}));
  const FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.openings.size(), 3U);
  EXPECT_THAT(plan.openings[1].rooms, ElementsAre(0, -1));
  EXPECT_THAT(plan.openings[2].rooms, ElementsAre(1, -1));
  EXPECT_THAT(plan.rooms[0].planes, ElementsAre(0, 1, 2, 4, 5, 6, 8));
  setRooms(plan, map);
  ASSERT_EQ(map.openings.size(), 2U);
  EXPECT_THAT(map.openings[1].rooms, ElementsAre(0, 1));
}

/** A leaf is seen in the wall, and is no wall. */
TEST(FloorPlan, LeavesAreSeenInTheirOpenings)
{
  CompactMap map = makeRooms();
  map.planes.push_back(
      makePlane(-Vector3f::UnitX(),
                {{4.06F, 1, 1}, {4.06F, 1, 1.9F}, {4.06F, -1, 1.9F}, {4.06F, -1, 1}}));
  const FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.openings.size(), 3U);
  EXPECT_TRUE(std::isnan(plan.openings[0].leaf)) << "the window";
  EXPECT_NEAR(plan.openings[1].leaf, 0.06, 1e-5);
  for (const PlanWall& wall : plan.walls)
    EXPECT_EQ(wall.role, wall.plane == 8 ? SurfaceRole::DoorLeaf : SurfaceRole::Wall);
}

/** The sides of doorways are more exact than the outline of the wall. */
TEST(FloorPlan, OpeningsEndAtTheirReveals)
{
  CompactMap map = makeRooms();
  for (const std::size_t plane : {6U, 7U})
    for (Vector3f& place : map.planes[plane].polygons[0].outer) {
      place.z() += place.z() > 1.8F && place.z() < 2 ? 0.03F : 0;
      place.z() -= place.z() > 0.9F && place.z() < 1.1F ? 0.03F : 0;
    }
  EXPECT_NEAR(lengthOf(makeFloorPlan(map).openings[1]), 0.96, 1e-5);
  const auto reveal = [&](float z, float way) {
    return makePlane(way * Vector3f::UnitZ(),
                     {{4, 1, z}, {4.1F, 1, z}, {4.1F, -1, z}, {4, -1, z}});
  };
  map.planes.push_back(reveal(1, 1));
  map.planes.push_back(reveal(1.9F, -1));
  const FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.openings.size(), 3U);
  for (const std::size_t door : {1U, 2U})
    EXPECT_NEAR(lengthOf(plan.openings[door]), 0.9, 1e-5);
}

/** Of a window over the whole height, only its sill and its sides may be seen. */
TEST(FloorPlan, SillsTellWindows)
{
  CompactMap map = makeRooms();
  map.planes[5] =
      makePlane(-Vector3f::UnitZ(),
                {{2.2F, 1, 3}, {6.1F, 1, 3}, {6.1F, -1.6F, 3}, {2.2F, -1.6F, 3}});
  EXPECT_EQ(makeFloorPlan(map).openings.size(), 2U)
      << "the rest of the wall was not seen";
  map.planes.push_back(
      makePlane(-Vector3f::UnitY(),
                {{0, 0.9F, 3}, {2.2F, 0.9F, 3}, {2.2F, 0.9F, 3.3F}, {0, 0.9F, 3.3F}}));
  const FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.openings.size(), 3U);
  EXPECT_TRUE(plan.openings[0].is_window);
  EXPECT_NEAR(lengthOf(plan.openings[0]), 2.2, 1e-5);
  EXPECT_NEAR(plan.openings[0].bottom, 0.1, 1e-5);
  EXPECT_TRUE(plan.furniture.empty()) << "a sill";
}

/** A wall between two rooms whose outer walls lie in one plane ends in the gap of that plane. */
TEST(FloorPlan, WallsEndOpenings)
{
  CompactMap map = makeRooms();
  // the far wall of both rooms with a window of each beside the wall between them
  map.planes[5] = makePlane(-Vector3f::UnitZ(),
                            {{0, 1, 3}, {6.1F, 1, 3}, {6.1F, -1.6F, 3}, {0, -1.6F, 3}},
                            {{{3, 0, 3}, {3, -1, 3}, {5, -1, 3}, {5, 0, 3}}});
  const FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.openings.size(), 4U);
  EXPECT_NEAR(lengthOf(plan.openings[0]), 0.9, 1e-5);
  EXPECT_NEAR(lengthOf(plan.openings[1]), 1, 1e-5);
}

TEST(FloorPlan, ShowsFurnitureAndColumns)
{
  CompactMap map = makeRooms();
  map.planes.push_back(makePlane(
      -Vector3f::UnitY(),
      {{1, 0.25F, 1}, {2, 0.25F, 1}, {2, 0.25F, 1.6F}, {1, 0.25F, 1.6F}})); // a table
  map.planes.push_back(makePlane(
      -Vector3f::UnitY(), {{3, 0.9F, 1}, {3.5F, 0.9F, 1}, {3.5F, 0.9F, 2}})); // a step
  BoxPatch box;
  box.center << 5, 0.5, 0.5;
  box.size << 1, 0.8, 0.6;
  box.axes << 1, 0, 0, 0, 0, 1, 0, -1, 0; // length, depth, height
  box.size << 1, 0.6, 1;
  map.boxes.push_back(box);
  CylinderPatch column;
  column.axis_point << 2, 0, 2.5;
  column.axis_direction = -Eigen::Vector3d::UnitY();
  column.axis_u = Eigen::Vector3d::UnitX();
  column.radius = 0.2;
  column.low = -1;
  column.high = 1.6;
  column.arc = 3;
  map.cylinders.push_back(column);
  column.high = 0; // a bin, below the section
  map.cylinders.push_back(column);
  const FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.furniture.size(), 3U);
  EXPECT_NEAR(plan.furniture[0].top, 1, 1e-5);
  EXPECT_NEAR(areaOf(plan.furniture[0].outline), 0.6, 1e-5);
  EXPECT_NEAR(plan.furniture[1].top, 0.75, 1e-5);
  EXPECT_EQ(plan.furniture[1].outline.size(), 4U);
  EXPECT_NEAR(plan.furniture[2].top, 1, 1e-5);
  ASSERT_EQ(plan.columns.size(), 1U);
  EXPECT_LT((plan.columns[0].center - Eigen::Vector2d(2, 2.5)).norm(), 1e-5);
  EXPECT_NEAR(plan.columns[0].begin, -1.5, 1e-9);
  EXPECT_NEAR(plan.columns[0].end, 1.5, 1e-9);
  map.planes[2].label.role = SurfaceRole::Furniture;
  for (const PlanWall& wall : makeFloorPlan(map).walls)
    EXPECT_EQ(wall.role, wall.plane == 2 ? SurfaceRole::Furniture : SurfaceRole::Wall);
}

/** Where a wall goes on above a cupboard, it goes on behind it. */
TEST(FloorPlan, WallsBehindFurnitureAreNotSeen)
{
  CompactMap map = makeRooms();
  map.planes.push_back(makePlane(
      -Vector3f::UnitZ(),
      {{0.9F, 1, 2.5F}, {2.3F, 1, 2.5F}, {2.3F, -1, 2.5F}, {0.9F, -1, 2.5F}}));
  const FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.unseen_walls.size(), 1U);
  EXPECT_EQ(plan.unseen_walls[0].plane, 5U);
  EXPECT_NEAR((plan.unseen_walls[0].to - plan.unseen_walls[0].from).norm(), 1.2, 1e-5);
  EXPECT_NEAR(plan.rooms[0].area, 12, 0.2) << "the room ends there";
}

TEST(FloorPlan, FurnitureIsNoOpening)
{
  CompactMap map = makeRooms();
  map.planes.push_back(makePlane(
      -Vector3f::UnitZ(),
      {{0.9F, 1, 2.5F}, {2.3F, 1, 2.5F}, {2.3F, -1, 2.5F}, {0.9F, -1, 2.5F}}));
  const FloorPlan plan = makeFloorPlan(map);
  ASSERT_EQ(plan.openings.size(), 2U);
  EXPECT_FALSE(plan.openings[0].is_window);
  EXPECT_FALSE(plan.openings[1].is_window);
}

TEST(FloorPlan, LowRoomsAreCutBelowTheirCeiling)
{
  CompactMap map = makeRooms();
  for (PlanePatch& plane : map.planes) {
    for (Vector3f& place : plane.polygons[0].outer)
      place.y() = 1 + (place.y() - 1) / 2;
    plane.coefficients[3] =
        -plane.coefficients.head<3>().dot(plane.polygons[0].outer[0].cast<double>());
  }
  EXPECT_NEAR(makeFloorPlan(map).cut, -1 + 0.6 * 1.3, 1e-6);
}

TEST(FloorPlan, UglyMapsGiveWhatTheyHave)
{
  const FloorPlan nothing = makeFloorPlan({});
  EXPECT_THAT(nothing.walls, IsEmpty());
  EXPECT_THAT(nothing.rooms, IsEmpty());

  CompactMap without_floor = makeRooms();
  without_floor.planes.erase(without_floor.planes.begin(),
                             without_floor.planes.begin() + 2);
  const FloorPlan walls = makeFloorPlan(without_floor);
  EXPECT_NEAR(walls.floor, -1, 1e-6);
  EXPECT_EQ(walls.walls.size(), 9U);
  EXPECT_THAT(walls.rooms, IsEmpty());

  CompactMap not_finite = makeRooms();
  not_finite.planes[5].polygons[0].outer[0].x() =
      std::numeric_limits<float>::quiet_NaN();
  not_finite.planes[2].polygons.clear();
  const FloorPlan rest = makeFloorPlan(not_finite);
  EXPECT_EQ(rest.walls.size(), 6U);
  EXPECT_EQ(rest.rooms.size(), 2U);

  CompactMap flat; // a floor without an extent
  flat.planes = {makePlane(-Vector3f::UnitY(), {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}})};
  EXPECT_THAT(makeFloorPlan(flat).rooms, IsEmpty());
}

std::size_t
countOf(const std::string& part, const std::string& text)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1))
    ++count;
  return count;
}

/** The size of the sheet of an SVG, millimetres. */
Eigen::Vector2d
viewBoxOf(const std::string& svg)
{
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
  std::istringstream(svg.substr(svg.find("viewBox=\"0 0 ") + 13)) >> size.x() >>
      size.y();
  return size;
}

TEST(FloorPlan, IsSavedAsSvg)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("floor_plan.svg");
  CompactMap map = makeRooms();
  setRooms(makeFloorPlan(map), map);
  map.rooms[1].label.name = "Hall & stairs";
  saveFloorPlan(path, makeFloorPlan(map));
  const std::string text = contentOf(path);
  EXPECT_THAT(text,
              HasSubstr("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
                        "width=\"100%\" viewBox=\"0 0 "));
  EXPECT_THAT(text, HasSubstr("<title>Floor plan, 1 : 50</title>"));
  EXPECT_EQ(countOf("<g", text), countOf("</g>", text));
  for (const char* layer :
       {"floor", "walls", "windows", "doors", "rooms", "dimensions", "north", "title"})
    EXPECT_EQ(countOf("<g id=\"" + std::string(layer) + "\">", text), 1U) << layer;
  EXPECT_THAT(text, HasSubstr(">Room 1</text>"));
  EXPECT_THAT(text, HasSubstr(">Hall &amp; stairs</text>"));
  EXPECT_THAT(text, HasSubstr(">0.90 × 2.00</text>"));
  EXPECT_EQ(countOf(">6.10</text>", text), 2U); // of the near and the far side
  // 6.1 m on the paper
  const Eigen::Vector2d size = viewBoxOf(text);
  EXPECT_GT(size.x(), 1000 * 6.1 / 50);
  EXPECT_LT(size.maxCoeff(), 287);
  saveFloorPlan(path, makeFloorPlan(map));
  EXPECT_EQ(contentOf(path), text);
  EXPECT_NO_THROW(saveFloorPlan(path, {}));
  EXPECT_THAT(contentOf(path), HasSubstr("</svg>"));
  EXPECT_THROW(saveFloorPlan(folder.path("none/floor_plan.svg"), {}),
               OutputFileException);
}

/** The same sheet as the SVG, without a display. */
TEST(FloorPlan, IsSavedAsPng)
{
  const TemporaryFolder folder;
  const FloorPlan plan = makeFloorPlan(makeRooms());
  saveFloorPlan(folder.path("plan.svg"), plan);
  saveFloorPlan(folder.path("plan.png"), plan);
  const Eigen::Vector2d size = viewBoxOf(contentOf(folder.path("plan.svg")));
  const RgbImage image = loadRgbImage(folder.path("plan.png"));
  EXPECT_NEAR(image.width, 6 * size.x(), 1);
  EXPECT_NEAR(image.height, 6 * size.y(), 1);
  const std::string first = contentOf(folder.path("plan.png"));
  saveFloorPlan(folder.path("plan.png"), plan);
  EXPECT_EQ(contentOf(folder.path("plan.png")), first);
  EXPECT_NO_THROW(saveFloorPlan(folder.path("plan.png"), {}));
  EXPECT_THROW(saveFloorPlan(folder.path("none/plan.png"), {}), OutputFileException);
}

} // namespace
} // namespace pcl::acmap::test
