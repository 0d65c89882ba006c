#include "simulated_rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr double degree = M_PI / 180;

/** Four times the pixels: as many points as a real view has. */
SeenRoom
seeSharply(SimulatedScene scene)
{
  scene.rig.width *= 2;
  scene.rig.height *= 2;
  scene.rig.focal_length *= 2;
  scene.rig.center_x = 2 * scene.rig.center_x + 0.5;
  scene.rig.center_y = 2 * scene.rig.center_y + 0.5;
  scene.sensor.points *= 4;
  return see(scene, 1);
}

double
distanceTo(const SimulatedRectangle& rectangle, const Eigen::Vector3d& place)
{
  const Eigen::Vector3d off = place - rectangle.corner;
  const auto along = [&](const Eigen::Vector3d& edge) {
    return std::clamp(off.dot(edge) / edge.squaredNorm(), 0.0, 1.0) * edge;
  };
  return (off - along(rectangle.edge_u) - along(rectangle.edge_v)).norm();
}

double
distanceTo(const TruthPlane& plane, const Eigen::Vector3d& place)
{
  double least = 1e9;
  for (const SimulatedRectangle& rectangle : plane.rectangles)
    least = std::min(least, distanceTo(rectangle, place));
  return least;
}

/** Where the ray of a point met its true plane: there the point would be without noise. */
Eigen::Vector3d
placeWithoutNoise(const SeenRoom& room, std::size_t i)
{
  const Eigen::Vector4d& plane =
      room.planes[static_cast<std::size_t>(room.truth[i])].coefficients;
  const Eigen::Vector3d sensor = room.viewpoints[0].cast<double>();
  const Eigen::Vector3d ray = (*room.cloud)[i].getVector3fMap().cast<double>() - sensor;
  return sensor -
         (plane.head<3>().dot(sensor) + plane[3]) / plane.head<3>().dot(ray) * ray;
}

/** How points near the edge between two planes are labelled. */
struct EdgeLabels {
  std::size_t points = 0;
  std::size_t right = 0;   ///< by the class
  std::size_t nearest = 0; ///< right ones, were each point given to the nearer plane
};

/** \param[in] reach metres to the edge */
EdgeLabels
labelsAtEdge(const SeenRoom& room,
             const RoomPlanes& found,
             std::int32_t a,
             std::int32_t b,
             double reach)
{
  EdgeLabels labels;
  for (std::size_t i = 0; i < room.truth.size(); ++i) {
    const std::int32_t truth = room.truth[i];
    if (truth != a && truth != b)
      continue;
    const std::int32_t other = truth == a ? b : a;
    if (distanceTo(room.planes[static_cast<std::size_t>(other)],
                   placeWithoutNoise(room, i)) > reach)
      continue;
    const Eigen::Vector3d point = (*room.cloud)[i].getVector3fMap().cast<double>();
    const auto offOf = [&](std::int32_t plane) {
      const Eigen::Vector4d& c =
          room.planes[static_cast<std::size_t>(plane)].coefficients;
      return std::abs(c.head<3>().dot(point) + c[3]);
    };
    const std::int32_t label = found.source_labels[i];
    ++labels.points;
    labels.right += label >= 0 && found.truth[static_cast<std::size_t>(label)] == truth;
    labels.nearest += offOf(truth) <= offOf(other);
  }
  return labels;
}

std::int32_t
planeNamed(const SeenRoom& room, const std::string& name)
{
  const auto plane = std::find_if(room.planes.begin(),
                                  room.planes.end(),
                                  [&](const TruthPlane& p) { return p.name == name; });
  return static_cast<std::int32_t>(plane - room.planes.begin());
}

/** The patch of a true plane; nullptr where none was found. */
const PlanePatch*
patchOf(const RoomPlanes& found, std::int32_t plane)
{
  for (std::size_t p = 0; p < found.patches.size(); ++p)
    if (found.truth[p] == plane)
      return &found.patches[p];
  return nullptr;
}

void
expectRightAtEdges(const SeenRoom& room,
                   const RoomPlanes& found,
                   const std::vector<std::pair<std::string, std::string>>& edges)
{
  for (const auto& [a, b] : edges) {
    const EdgeLabels labels =
        labelsAtEdge(room, found, planeNamed(room, a), planeNamed(room, b), 0.06);
    ASSERT_GT(labels.points, 400U) << a << ", " << b;
    const auto size = static_cast<double>(labels.points);
    EXPECT_GE(static_cast<double>(labels.right) / size, 0.98) << a << ", " << b;
    EXPECT_LT(static_cast<double>(labels.nearest) / size, 0.93) << a << ", " << b;
  }
}

TEST(SourceLabels, areRightAtInnerEdges)
{
  const SeenRoom room = seeSharply(makeRoomCorner(0.02));
  const RoomPlanes found = findPlanes(room);
  ASSERT_EQ(found.patches.size(), 3U);
  expectRightAtEdges(
      room,
      found,
      {{"far wall", "floor"}, {"far wall", "left wall"}, {"floor", "left wall"}});
  std::size_t right = 0;
  for (std::size_t i = 0; i < room.truth.size(); ++i)
    right +=
        found.source_labels[i] >= 0 &&
        found.truth[static_cast<std::size_t>(found.source_labels[i])] == room.truth[i];
  EXPECT_GT(static_cast<double>(right), 0.99 * static_cast<double>(room.truth.size()));
}

TEST(SourceLabels, areRightAtOuterEdges)
{
  const SeenRoom room = seeSharply(makeRoomWithDoor(0.02, 0.2));
  const RoomPlanes found = findPlanes(room);
  expectRightAtEdges(
      room, found, {{"box front", "box left"}, {"box front", "box top"}});
}

TEST(SourceLabels, planesAreThoseOfTheTruth)
{
  const SeenRoom room = seeSharply(makeRoomWithDoor(0.01, 0.1));
  const RoomPlanes found = findPlanes(room);
  for (const char* name :
       {"wall", "floor", "door", "box front", "box top", "box left"}) {
    const std::int32_t plane = planeNamed(room, name);
    const PlanePatch* patch = patchOf(found, plane);
    ASSERT_TRUE(patch) << name;
    const Eigen::Vector4d& truth =
        room.planes[static_cast<std::size_t>(plane)].coefficients;
    EXPECT_GT(patch->coefficients.head<3>().dot(truth.head<3>()), 0) << name;
    EXPECT_LT(angleFrom(*patch, truth.head<3>()), 0.3 * degree) << name;
    EXPECT_NEAR(truth.head<3>().dot(patch->center) + truth[3], 0, 0.002) << name;
  }
}

/** The reveal of a door is two cells wide: the cells guess it, the points know it. */
TEST(SourceLabels, revealsAreFound)
{
  const SeenRoom room = seeSharply(makeRoomWithDoor(0.01, 0.1));
  const auto patch = [&](const RoomPlanes& found) {
    return patchOf(found, planeNamed(room, "door 1 near side"));
  };
  const RoomPlanes found = findPlanes(room);
  ASSERT_TRUE(patch(found));
  EXPECT_LT(angleFrom(*patch(found), {1, 0, 0}), 1 * degree);
  EXPECT_NEAR(distanceFrom(*patch(found), {-1.1, 0, 3.05}), 0, 0.008);
  const RoomPlanes without_source = findPlanes(room, [](auto& clustering) {
    clustering.template setSourceCloud<PointXYZ>(nullptr);
  });
  EXPECT_TRUE(without_source.source_labels.empty());
  EXPECT_FALSE(patch(without_source)) << "nobody could judge it";
  EXPECT_GE(without_source.patches.size(), 5U);
}

/** A board that stands in the hypotheses but not in the source. */
TEST(SourceLabels, planeWithoutPointsIsRefuted)
{
  const VotingMesh wall = makeWall(2, 2);
  const VotingMesh board = placedAt(makeWall(1, 1), 0, 0, 0.5);
  const Cloud::ConstPtr source = wall.cloud.makeShared();
  const auto setSource = [&](Clustering& clustering) {
    clustering.setSourceCloud(source);
  };
  const Clustered alone = clusterOn(wall, setSource);
  ASSERT_EQ(alone.patches.size(), 1U);
  EXPECT_EQ(alone.report.refuted_regions, 0U);
  const Clustered found = clusterOn(together(wall, board), setSource);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.report.refuted_regions, 1U);
  EXPECT_NEAR(found.patches[0].coefficients[2], 1, 1e-6);
  EXPECT_EQ(std::count(found.labels.begin(), found.labels.end(), -1),
            static_cast<std::ptrdiff_t>(board.cloud.size()));
  EXPECT_EQ(std::count(found.source_labels.begin(), found.source_labels.end(), 0),
            static_cast<std::ptrdiff_t>(source->size()));
}

TEST(SourceLabels, sourceWithNothingNearRefutesAll)
{
  const Cloud::ConstPtr far = placedAt(makeWall(1, 1), 50, 0, 0).cloud.makeShared();
  const Clustered found = clusterOn(
      makeWall(2, 2), [&](Clustering& clustering) { clustering.setSourceCloud(far); });
  EXPECT_TRUE(found.patches.empty());
  EXPECT_EQ(found.report.refuted_regions, 1U);
  EXPECT_FALSE(found.report.remarks.empty());
  ASSERT_EQ(found.source_labels.size(), far->size());
  EXPECT_EQ(*std::max_element(found.source_labels.begin(), found.source_labels.end()),
            -1);
}

/** What noise beside a narrow recess makes up is no plane. */
TEST(SourceLabels, everyPatchHasAnArea)
{
  for (const double noise : {0.01, 0.02})
    for (const double depth : {0.1, 0.2})
      for (const PlanePatch& patch :
           findPlanes(seeSharply(makeRoomWithDoor(noise, depth))).patches) {
        EXPECT_GT(patch.area, 0.01) << noise << ", " << depth;
        EXPECT_FALSE(patch.polygons.empty()) << noise << ", " << depth;
      }
}

} // namespace
} // namespace pcl::acmap::test
