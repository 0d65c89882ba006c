#include "room_planes.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

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

/** The reveal of a door is two cells wide: cells cannot determine it, but the points
 * can. */
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
  const RoomPlanes without_source = findPlanes(
      room, [](auto& clustering) { clustering.setSourceCloud(Cloud::ConstPtr()); });
  EXPECT_TRUE(without_source.source_labels.empty());
  EXPECT_FALSE(patch(without_source)) << "nobody could judge it";
  EXPECT_GE(without_source.patches.size(), 5U);
}

/** A board that exists in the hypotheses, but not in the source. */
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

/** For example a sweep of a line laser: the points determine the tilt along the line,
 * the hypotheses the tilt across it. */
TEST(SourceLabels, lineOfPointsDoesNotTiltItsWall)
{
  Random random(5);
  const auto line = std::make_shared<Cloud>();
  for (int i = 0; i < 3000; ++i)
    line->push_back(toPoint({random.uniform(-1.4, 1.4),
                             1e-4 * random.normal(),
                             2 + 0.002 * random.normal()}));
  const Clustered found =
      clusterOn(placedAt(makeWall(3, 2), 0, 0, 2),
                [&](Clustering& clustering) { clustering.setSourceCloud(line); });
  ASSERT_EQ(found.patches.size(), 1U);
  const PlanePatch& patch = found.patches[0];
  EXPECT_LT(angleFrom(patch, {0, 0, 1}), 0.5 * degree);
  EXPECT_NEAR(distanceFrom(patch, {0, 0, 2}), 0, 0.001);
  EXPECT_LT(std::sqrt(patch.covariance(0, 0)), 0.001);
  EXPECT_NEAR(std::sqrt(patch.covariance(1, 1)), 1 * degree, 0.3 * degree)
      << "what was guessed is no knowledge";
}

/** The remark on an empty result must count regions that were dropped earlier. */
TEST(SourceLabels, smallRegionsAreCounted)
{
  const VotingMesh board = makeWall(0.5, 0.5);
  const Cloud::ConstPtr source = board.cloud.makeShared();
  for (const Cloud::ConstPtr& judge : {Cloud::ConstPtr(), source}) {
    const Clustered found = clusterOn(board, [&](Clustering& clustering) {
      clustering.setMinArea(1);
      clustering.setSourceCloud(judge);
    });
    EXPECT_TRUE(found.patches.empty());
    EXPECT_EQ(found.report.small_regions, 1U);
    ASSERT_FALSE(found.report.remarks.empty());
    EXPECT_NE(found.report.remarks.back().find("1 regions"), std::string::npos)
        << found.report.remarks.back();
  }
}

/** Noise next to a narrow recess must not create planes. */
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

/** This includes strips, whose area was that of the cells over which they grew. */
TEST(SourceLabels, noPatchHasAnAreaWithoutAMesh)
{
  const RoomPlanes found =
      findPlanes(seeSharply(makeRoomWithDoor(0.01, 0.1)),
                 [](auto& clustering) { clustering.setTriangles(TriangleMesh()); });
  EXPECT_GE(found.patches.size(), 5U);
  for (const PlanePatch& patch : found.patches) {
    EXPECT_EQ(patch.area, 0);
    EXPECT_TRUE(patch.polygons.empty());
  }
}

} // namespace
} // namespace pcl::acmap::test
