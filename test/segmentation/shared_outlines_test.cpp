#include "closed_meshes.h"
#include "clustering_runs.h"
#include "polygon_checks.h"
#include "room_planes.h"

#include <pcl/core/map_topology.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace pcl::acmap::test {
namespace {

/** Number of edges of each kind. */
std::map<EdgeKind, std::size_t>
kindsOf(const MapTopology& topology)
{
  std::map<EdgeKind, std::size_t> kinds;
  for (const MapEdge& edge : topology.edges)
    ++kinds[edge.kind];
  return kinds;
}

/** What holds for all outlines: kinds and neighbours agree with the polygons. */
void
expectConsistent(const std::vector<PlanePatch>& patches)
{
  const MapTopology topology = topologyOf(patches);
  std::map<std::array<std::int32_t, 2>, std::vector<std::int32_t>> planes_of;
  for (const MapFace& face : topology.faces) {
    const PlanePolygon& polygon = patches[static_cast<std::size_t>(face.plane)]
                                      .polygons[static_cast<std::size_t>(face.polygon)];
    std::size_t points = 0;
    std::vector<std::vector<std::int32_t>> loops = face.holes;
    loops.push_back(face.outer);
    for (const std::vector<std::int32_t>& loop : loops) {
      points += loop.size();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto [low, high] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
        planes_of[{low, high}].push_back(face.plane);
      }
    }
    EXPECT_EQ(polygon.edges.size(), points);
  }
  ASSERT_EQ(planes_of.size(), topology.edges.size());
  for (const MapEdge& edge : topology.edges) {
    std::vector<std::int32_t> planes = planes_of.at(edge.vertices);
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    EXPECT_EQ(edge.kind == EdgeKind::Crease, planes.size() > 1);
    if (edge.kind == EdgeKind::Crease) {
      EXPECT_EQ(edge.planes[0], planes[0]);
      EXPECT_EQ(edge.planes[1], planes[1]);
    }
    for (const std::int32_t vertex : edge.vertices)
      for (const std::int32_t plane : edge.planes) {
        if (plane < 0)
          continue;
        EXPECT_LT(
            std::abs(distanceFrom(
                patches[static_cast<std::size_t>(plane)],
                topology.vertices[static_cast<std::size_t>(vertex)].cast<double>())),
            edge.kind == EdgeKind::Contact ? 0.02 : 1e-5);
      }
  }
}

TEST(SharedOutlines, cubeHasEightCornersAndTwelveCreases)
{
  for (const double noise : {0.0, 0.002}) {
    const Clustered found =
        clusterOn(withNoise(makeCubeMesh(20, grid), {1, 1, 1}, noise));
    ASSERT_EQ(found.patches.size(), 6U);
    const MapTopology topology = topologyOf(found.patches);
    EXPECT_EQ(topology.vertices.size(), 8U);
    EXPECT_EQ(topology.faces.size(), 6U);
    EXPECT_EQ(topology.edges.size(), 12U);
    EXPECT_EQ(kindsOf(topology)[EdgeKind::Crease], 12U);
    EXPECT_EQ(found.report.contour_outlines, 0U);
    expectConsistent(found.patches);
  }
}

/** The other edges are open: nobody told where the sensors were. */
TEST(SharedOutlines, cornerSharesThreeEdges)
{
  const Clustered found = clusterOn(makeCornerMesh());
  const MapTopology topology = topologyOf(found.patches);
  EXPECT_EQ(topology.vertices.size(), 7U);
  EXPECT_EQ(kindsOf(topology)[EdgeKind::Crease], 3U);
  EXPECT_EQ(kindsOf(topology)[EdgeKind::Open], 6U);
  expectConsistent(found.patches);
}

/** A board that stands on a wall, which goes on on both sides of it. */
TEST(SharedOutlines, boardOnAWallEndsInAContact)
{
  VotingMesh board = makeWall(1, 1); // turned: x stays, y becomes z
  for (PointXYZ& point : board.cloud) {
    point.z = point.y + 0.525F;
    point.y = 0;
  }
  const Clustered found = clusterOn(together(makeWall(4, 2.5), board));
  ASSERT_EQ(found.patches.size(), 2U);
  const MapTopology topology = topologyOf(found.patches);
  EXPECT_EQ(kindsOf(topology)[EdgeKind::Contact], 1U);
  for (const MapEdge& edge : topology.edges)
    if (edge.kind == EdgeKind::Contact) {
      EXPECT_EQ(edge.planes, (std::array<std::int32_t, 2>{1, 0}));
    }
  expectConsistent(found.patches);
}

/** Wall, floor and box of a simulated room, with a recessed door. */
TEST(SharedOutlines, roomTellsCreasesRimsAndFrontiers)
{
  for (const double noise : {0.003, 0.006}) {
    const RoomPlanes found = findPlanes(see(makeRoomWithDoor(noise, 0.2), 1));
    std::map<EdgeKind, std::size_t> kinds = kindsOf(topologyOf(found.patches));
    EXPECT_GE(kinds[EdgeKind::Crease], 6U) << "door, box and floor";
    EXPECT_GE(kinds[EdgeKind::Rim], 1U) << "the box hides the wall behind it";
    EXPECT_GE(kinds[EdgeKind::Frontier], 3U) << "the image ends";
    EXPECT_EQ(kinds[EdgeKind::Open], 0U);
    expectConsistent(found.patches);
    for (const PlanePatch& patch : found.patches)
      expectSound(patch);
  }
}

/** A wall with a hole of 16 cm, and a wall 1 m behind it. */
SimulatedScene
makeWallWithPeephole(bool has_wall_behind)
{
  SimulatedScene scene = makeEmptyScene(0.003);
  const auto add = [&](const char* name, double x, double y, double w, double h) {
    scene.geometry.addRectangle(name, "wall", {{x, y, 2}, {w, 0, 0}, {0, -h, 0}}, {});
  };
  add("left", -1.2, 0.9, 1.12, 1.8);
  add("right", 0.08, 0.9, 1.12, 1.8);
  add("below", -0.08, 0.9, 0.16, 0.82);
  add("above", -0.08, -0.08, 0.16, 0.82);
  if (has_wall_behind)
    scene.geometry.addRectangle(
        "behind", "behind", {{-2, 1.5, 3}, {4, 0, 0}, {0, -3, 0}}, {});
  return scene;
}

/** Too small to be told from missing measurements, unless a sensor looked through. */
TEST(SharedOutlines, nothingIsClosedWhereASensorLookedThrough)
{
  for (const bool has_wall_behind : {true, false}) {
    const RoomPlanes found =
        findPlanes(seeSharply(makeWallWithPeephole(has_wall_behind)));
    std::size_t holes = 0;
    for (const PlanePatch& patch : found.patches)
      if (patch.center.z() < 2.5)
        for (const PlanePolygon& polygon : patch.polygons)
          holes += polygon.holes.size();
    if (has_wall_behind) {
      EXPECT_EQ(holes, 1U);
    }
    expectConsistent(found.patches);
  }
}

TEST(SharedOutlines, areTheSameForAnyNumberOfThreads)
{
  const SeenRoom room = see(makeRoomWithDoor(0.005, 0.2), 2);
  const auto with = [&](unsigned threads) {
    return findPlanes(
        room, [&](auto& clustering) { clustering.setNumberOfThreads(threads); });
  };
  const RoomPlanes found = with(1), again = with(3);
  ASSERT_EQ(found.patches.size(), again.patches.size());
  for (std::size_t p = 0; p < found.patches.size(); ++p)
    for (std::size_t k = 0; k < found.patches[p].polygons.size(); ++k)
      EXPECT_EQ(found.patches[p].polygons[k].outer, again.patches[p].polygons[k].outer);
}

} // namespace
} // namespace pcl::acmap::test
