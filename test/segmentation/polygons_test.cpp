#include "closed_meshes.h"
#include "clustering_runs.h"
#include "polygon_checks.h"
#include "room_planes.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

/** A wall of 4 m by 2.5 m with a window of 1.2 m by 1 m in its centre. */
VotingMesh
makeWallWithWindow()
{
  return without(makeWall(4, 2.5), [](const PointXYZ& point) {
    return std::abs(point.x) < 0.59F && std::abs(point.y) < 0.49F;
  });
}

bool
hasVertexAt(const std::vector<Eigen::Vector3f>& loop,
            const Eigen::Vector3d& place,
            double tolerance)
{
  return std::any_of(loop.begin(), loop.end(), [&](const Eigen::Vector3f& vertex) {
    return (vertex.cast<double>() - place).norm() < tolerance;
  });
}

void
expectRectangle(const std::vector<Eigen::Vector3f>& loop,
                double width,
                double height,
                double tolerance = 1e-4)
{
  for (const double x : {-width / 2, width / 2})
    for (const double y : {-height / 2, height / 2})
      EXPECT_TRUE(hasVertexAt(loop, {x, y, 0}, tolerance)) << x << ", " << y;
}

TEST(PlanePolygons, windowStaysOpen)
{
  for (const bool is_turned : {false, true}) {
    const VotingMesh wall = makeWallWithWindow();
    const Clustered found = clusterOn(is_turned ? turnedOver(wall) : wall);
    ASSERT_EQ(found.patches.size(), 1U);
    const PlanePatch& patch = found.patches[0];
    EXPECT_NEAR(patch.coefficients[2], is_turned ? -1 : 1, 1e-6);
    EXPECT_NEAR(patch.area, 10 - 1.2, 0.06) << "the mesh cuts two corners off";
    ASSERT_EQ(patch.polygons.size(), 1U);
    EXPECT_EQ(patch.polygons[0].outer.size(), 4U);
    expectRectangle(patch.polygons[0].outer, 4, 2.5);
    ASSERT_EQ(patch.polygons[0].holes.size(), 1U);
    expectRectangle(patch.polygons[0].holes[0], 1.2, 1, 1.1 * grid);
    expectSound(patch);
  }
}

/** Within W_d = 0.8 m of one hypothesis, no plane is large enough to surround the window. */
TEST(PlanePolygons, planesOfThePaperHaveThemToo)
{
  for (const SupporterReach reach :
       {SupporterReach::Hypothesis, SupporterReach::Members}) {
    const Clustered found =
        clusterOn(makeWallWithWindow(), [&](Clustering& clustering) {
          clustering.setNoiseDriven(false);
          clustering.setSupporterReach(reach);
        });
    if (reach == SupporterReach::Members) {
      ASSERT_EQ(found.patches.size(), 1U);
      EXPECT_EQ(found.patches[0].polygons[0].holes.size(), 1U);
    }
    else
      EXPECT_GE(found.patches.size(), 5U);
    for (const PlanePatch& patch : found.patches)
      expectSound(patch);
  }
}

TEST(PlanePolygons, smallHolesAreClosed)
{
  const VotingMesh mesh = without(makeWall(2, 2), [](const PointXYZ& point) {
    return std::abs(point.x) < 0.01F && std::abs(point.y) < 0.01F;
  });
  const Clustered found = clusterOn(mesh);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_TRUE(found.patches[0].polygons[0].holes.empty()) << "a point that was missed";
  EXPECT_NEAR(found.patches[0].area, 4, 1e-4);
}

TEST(PlanePolygons, islandInAWindowIsAPolygonOfItsOwn)
{
  const VotingMesh mesh = together(makeWallWithWindow(), makeWall(0.5, 0.5));
  const Clustered found = clusterOn(mesh);
  ASSERT_EQ(found.patches.size(), 1U);
  const PlanePatch& patch = found.patches[0];
  ASSERT_EQ(patch.polygons.size(), 2U);
  EXPECT_EQ(patch.polygons[0].holes.size(), 1U);
  expectRectangle(patch.polygons[1].outer, 0.5, 0.5);
  EXPECT_NEAR(patch.area, 10 - 1.2 + 0.25, 0.06);
  expectSound(patch);
}

/** The vertices of the meshes end half a spacing before the edges of a room's
 * corner. */
TEST(PlanePolygons, areDrawnToTheEdges)
{
  for (const double noise : {0.0, 0.0005}) {
    const Clustered found = clusterOn(withNoise(makeCornerMesh(), {1, 1, 1}, noise));
    ASSERT_EQ(found.patches.size(), 3U);
    Eigen::Matrix3d normals;
    Eigen::Vector3d offsets;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector4d& c =
          found.patches[static_cast<std::size_t>(k)].coefficients;
      normals.row(k) = c.head<3>();
      offsets[k] = -c[3];
    }
    const Eigen::Vector3d corner = normals.inverse() * offsets;
    EXPECT_LT(corner.norm(), 0.002);
    for (const PlanePatch& patch : found.patches) {
      expectSound(patch);
      ASSERT_EQ(patch.polygons.size(), 1U);
      EXPECT_TRUE(hasVertexAt(patch.polygons[0].outer, corner, 1e-5));
      EXPECT_NEAR(patch.area, 2.025 * 2.025, 0.1);
      std::size_t on_edges = 0; // ends of the two edges, and the corner twice
      for (const PlanePatch& other : found.patches)
        for (const Eigen::Vector3f& vertex : patch.polygons[0].outer)
          on_edges += &other != &patch &&
                      std::abs(distanceFrom(other, vertex.cast<double>())) < 1e-5;
      EXPECT_EQ(on_edges, 4U);
    }
  }
}

TEST(PlanePolygons, meetInTheCornersOfACube)
{
  const Clustered found = clusterOn(makeCubeMesh(20, grid));
  ASSERT_EQ(found.patches.size(), 6U);
  for (const PlanePatch& patch : found.patches) {
    ASSERT_EQ(patch.polygons.size(), 1U);
    EXPECT_EQ(patch.polygons[0].outer.size(), 4U);
    for (const Eigen::Vector3f& vertex : patch.polygons[0].outer)
      EXPECT_LT((vertex.cwiseAbs() - Eigen::Vector3f::Constant(0.5F)).norm(), 1e-5F);
    expectSound(patch);
  }
}

/** A wall with a window, behind which there are no measurements. */
SimulatedScene
makeRoomWithWindow(double noise)
{
  SimulatedScene scene = makeEmptyScene(noise);
  const auto add = [&](const char* name, double x, double y, double w, double h) {
    scene.geometry.addRectangle(name, "wall", {{x, y, 3}, {w, 0, 0}, {0, -h, 0}}, {});
  };
  add("left", -1.8, 1.2, 1.2, 2.4);
  add("right", 0.6, 1.2, 1.2, 2.4);
  add("below", -0.6, 1.2, 1.2, 0.7);
  add("above", -0.6, -0.5, 1.2, 0.7);
  return scene;
}

TEST(PlanePolygons, windowThatWasSeenStaysOpen)
{
  for (const double noise : {0.005, 0.01, 0.02}) {
    const RoomPlanes found = findPlanes(see(makeRoomWithWindow(noise), 1));
    ASSERT_EQ(found.patches.size(), 1U);
    const PlanePatch& patch = found.patches[0];
    expectSound(patch);
    ASSERT_EQ(patch.polygons.size(), 1U);
    ASSERT_EQ(patch.polygons[0].holes.size(), 1U);
    const FlatLoop hole = flattened(patch, patch.polygons[0].holes[0]);
    EXPECT_NEAR(-areaOf(hole), 1.2, 4.4 * found.voxel) << "square metres";
    for (const double x : {-0.6, 0.6})
      for (const double y : {-0.5, 0.5})
        EXPECT_LT(distanceToLine(hole, flattened(patch, {Eigen::Vector3f(x, y, 3)})[0]),
                  1.5 * found.voxel);
  }
}

class SeenPolygons : public testing::TestWithParam<double> {};

TEST_P(SeenPolygons, areSoundAndInsideOfTheTruth)
{
  for (const std::uint64_t seed : {1, 2, 3})
    for (const bool has_door : {true, false}) {
      const SeenRoom room =
          see(has_door ? makeRoomWithDoor(GetParam(), 0.2) : makeRoomCorner(GetParam()),
              seed);
      const RoomPlanes found = findPlanes(room);
      EXPECT_GE(found.patches.size(), 3U);
      for (std::size_t p = 0; p < found.patches.size(); ++p) {
        expectSound(found.patches[p]);
        const TruthPlane& truth = room.planes[static_cast<std::size_t>(found.truth[p])];
        for (const PlanePolygon& polygon : found.patches[p].polygons)
          for (const Eigen::Vector3f& vertex : polygon.outer)
            EXPECT_LT(distanceTo(truth, vertex.cast<double>()), found.report.spacing)
                << truth.name;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(PlanePolygons, SeenPolygons, testing::Values(0.005, 0.01));

} // namespace
} // namespace pcl::acmap::test
