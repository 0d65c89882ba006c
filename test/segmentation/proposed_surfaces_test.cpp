#include "polygon_checks.h"
#include "room_planes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;

constexpr double floor_y = 1.1, wall_z = 3; // metres

void
addFloor(SimulatedScene& scene)
{
  scene.geometry.addRectangle(
      "floor", "floor", {{-3, floor_y, 0}, {8, 0, 0}, {0, 0, 6}}, {});
}

/** A piece of the far wall. */
void
addFarWall(SimulatedScene& scene, const std::string& name, double from, double to)
{
  scene.geometry.addRectangle(
      name, "wall", {{from, floor_y, wall_z}, {to - from, 0, 0}, {0, -3, 0}}, {});
}

/** A second camera, on the right of the first one. */
void
addView(SimulatedScene& scene, double x)
{
  scene.views.push_back(Eigen::Isometry3d::Identity());
  scene.views.back().translation().x() = x;
}

/** Floor and wall. */
SimulatedScene
makeWallAndFloor()
{
  SimulatedScene scene = makeEmptyScene(0.003);
  addFloor(scene);
  addFarWall(scene, "wall", -3, 5);
  addView(scene, 2);
  return scene;
}

const PlanePatch&
patchNamed(const SeenRoom& room, const RoomPlanes& found, const std::string& name)
{
  const PlanePatch* const patch = patchOf(found, planeNamed(room, name));
  EXPECT_TRUE(patch) << name;
  static const PlanePatch none;
  return patch ? *patch : none;
}

bool
contains(const PlanePatch& patch,
         const std::vector<PlanePolygon>& polygons,
         const Vector3d& point)
{
  const FlatLoop place = flattened(patch, {point.cast<float>()});
  for (const PlanePolygon& polygon : polygons) {
    bool is_inside = isInside(flattened(patch, polygon.outer), place[0]);
    for (const auto& hole : polygon.holes)
      is_inside = is_inside && !isInside(flattened(patch, hole), place[0]);
    if (is_inside)
      return true;
  }
  return false;
}

/** What holds for all proposals: on the plane, simple, counter-clockwise, beside the
 * polygons, and part of no area. */
void
expectSoundProposals(const PlanePatch& patch)
{
  PlanePatch alone = patch;
  alone.polygons = patch.proposed;
  alone.area = 0;
  for (const PlanePolygon& polygon : alone.polygons) {
    EXPECT_TRUE(polygon.edges.empty());
    alone.area += areaOf(flattened(patch, polygon.outer));
    for (const auto& hole : polygon.holes)
      alone.area += areaOf(flattened(patch, hole));
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();
    for (const Eigen::Vector3f& point : polygon.outer)
      middle += point / static_cast<float>(polygon.outer.size());
    if (contains(patch, {polygon}, middle.cast<double>())) {
      EXPECT_FALSE(contains(patch, patch.polygons, middle.cast<double>()));
    }
  }
  expectSound(alone);
  expectSound(patch); // whose area is that of its polygons
}

void
expectNoProposals(const RoomPlanes& found)
{
  for (const PlanePatch& patch : found.patches)
    EXPECT_TRUE(patch.proposed.empty()) << patch.coefficients.transpose();
}

/** Checks every centimetre of a rectangle, but for \a slack along its border. */
void
expectProposed(const PlanePatch& patch,
               const Vector3d& corner,
               const Vector3d& u,
               const Vector3d& v,
               double slack)
{
  std::size_t missing = 0;
  for (double s = slack; s < u.norm() - slack; s += 0.01)
    for (double t = slack; t < v.norm() - slack; t += 0.01)
      missing += contains(patch,
                          patch.proposed,
                          corner + s * u.normalized() + t * v.normalized())
                     ? 0
                     : 1;
  EXPECT_EQ(missing, 0U);
}

/** Its top and its front are in front of what it hides. */
TEST(ProposedSurfaces, wallAndFloorBehindABoxAgainstThem)
{
  SimulatedScene scene = makeWallAndFloor();
  scene.geometry.addBox("box", {0.6, 0.7, 2.5}, {1.4, floor_y, wall_z}, {});
  const SeenRoom room = seeSharply(scene);
  const RoomPlanes found = findPlanes(room);
  const auto expectHidden =
      [&](const std::string& name, const Vector3d& corner, const Vector3d& v) {
        const PlanePatch& patch = patchNamed(room, found, name);
        ASSERT_EQ(patch.proposed.size(), 1U) << name;
        const Vector3d u(0.8, 0, 0);
        expectProposed(patch, corner, u, v, 0.03);
        EXPECT_NEAR(areaOf(flattened(patch, patch.proposed[0].outer)),
                    u.norm() * v.norm(),
                    0.03 * 2 * (u.norm() + v.norm()));
      };
  expectHidden("wall", {0.6, 0.7, wall_z}, {0, floor_y - 0.7, 0});
  expectHidden("floor", {0.6, floor_y, 2.5}, {0, 0, 0.5});
  for (const PlanePatch& patch : found.patches)
    expectSoundProposals(patch);
}

/** Its shadow is larger than the box. */
TEST(ProposedSurfaces, wallBehindABoxBeforeIt)
{
  SimulatedScene scene = makeWallAndFloor();
  scene.geometry.addBox("box", {0.6, 0.4, 2}, {1.4, floor_y, 2.4}, {});
  const SeenRoom room = seeSharply(scene);
  const RoomPlanes found = findPlanes(room);
  const PlanePatch wall = patchNamed(room, found, "wall");
  ASSERT_EQ(wall.proposed.size(), 1U);
  EXPECT_TRUE(contains(wall, wall.proposed, {1, floor_y - 0.03, wall_z}));
  EXPECT_TRUE(contains(wall, wall.proposed, {1, 0.8, wall_z}));
  for (const PlanePatch& patch : found.patches)
    expectSoundProposals(patch);
}

TEST(ProposedSurfaces, nothingWithoutFurniture)
{
  expectNoProposals(findPlanes(seeSharply(makeWallAndFloor())));
}

/** Whatever is behind the door: a room, or the panel of the door, 5 or 20 cm behind. */
TEST(ProposedSurfaces, noDoorIsClosed)
{
  for (const double depth : {0.05, 0.2, 1.5}) {
    SimulatedScene scene = makeEmptyScene(0.003);
    addFloor(scene);
    WallOpenings door;
    door.at = {3.4};
    door.width = 1;
    door.depth = depth;
    door.name = "door";
    door.floor = "floor";
    scene.geometry.addWall(
        "wall", "wall", {{-3, floor_y, wall_z}, {8, 0, 0}, {0, -3, 0}}, {}, door);
    addView(scene, 2);
    const SeenRoom room = seeSharply(scene);
    const RoomPlanes found = findPlanes(room);
    EXPECT_TRUE(patchNamed(room, found, "wall").proposed.empty()) << depth;
  }
}

/** A wall in two pieces: nothing is known of what is between them. */
TEST(ProposedSurfaces, openEndsStayOpen)
{
  SimulatedScene scene = makeEmptyScene(0.003);
  addFloor(scene);
  for (const double x : {-1.2, 1.2})
    scene.geometry.addRectangle(
        x < 0 ? "left" : "right",
        x < 0 ? "left" : "right",
        x < 0 ? SimulatedRectangle{{x, floor_y, 0}, {0, 0, 6}, {0, -3, 0}}
              : SimulatedRectangle{{x, floor_y, 6}, {0, 0, -6}, {0, -3, 0}},
        {});
  expectNoProposals(findPlanes(seeSharply(scene)));
}

/** A block from floor to ceiling: what is inside is outside of the room. */
TEST(ProposedSurfaces, nothingInsideOfABlock)
{
  SimulatedScene scene = makeWallAndFloor();
  scene.geometry.addBox("block", {0.6, -3, 2}, {1.4, floor_y, wall_z}, {});
  const SeenRoom room = seeSharply(scene);
  const RoomPlanes found = findPlanes(room);
  EXPECT_TRUE(patchNamed(room, found, "floor").proposed.empty());
}

} // namespace
} // namespace pcl::acmap::test
