#include "room_planes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Position of a point without noise: intersection of its ray with the true plane. */
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

/** Labels of the points near the edge between two planes. */
struct EdgeLabels {
  std::size_t points = 0;
  std::size_t right = 0;   ///< correct labels of the class
  std::size_t nearest = 0; ///< correct labels if each point were assigned to the nearer
                           ///< plane
};

/** \param[in] reach maximum distance from the edge, metres */
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

TEST(EdgeLabels, areRightAtInnerEdges)
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

TEST(EdgeLabels, areRightAtOuterEdges)
{
  const SeenRoom room = seeSharply(makeRoomWithDoor(0.02, 0.2));
  const RoomPlanes found = findPlanes(room);
  expectRightAtEdges(
      room, found, {{"box front", "box left"}, {"box front", "box top"}});
}

} // namespace
} // namespace pcl::acmap::test
