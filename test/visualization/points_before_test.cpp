#include "layer_actors.h"
#include "viewed_room.h"

#include <pcl/conversions.h>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using Layers = std::set<SceneLayer>;

TEST(PointsBefore, MoveWithThePosesThatSawThem)
{
  LayeredScene scene = makeViewedRoom();
  auto& poses = scene.trajectory_before.poses;
  poses[1] = scene.map.trajectory.poses[1] * Eigen::Translation3d(0.25, 0, 0) *
             Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY());
  const auto after = typed(scene.points),
             before = typed(pointsUnder(scene, scene.trajectory_before));
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto view = static_cast<std::size_t>(after[i].view);
    const Eigen::Vector3d seen = scene.map.trajectory.poses[view].inverse() *
                                 after[i].getVector3fMap().cast<double>();
    EXPECT_LT((before[i].getVector3fMap().cast<double>() - poses[view] * seen).norm(),
              1e-5);
    EXPECT_EQ(before[i].view, after[i].view);
  }
}

TEST(PointsBefore, OfNoPoseAreLeftOut)
{
  LayeredScene scene = makeViewedRoom();
  auto points = typed(scene.points);
  points[0].view = -1;
  points[1].view = 1000000;
  toPCLPointCloud2(points, scene.points);
  const auto before = typed(pointsUnder(scene, scene.trajectory_before));
  EXPECT_FALSE(before[0].getVector3fMap().allFinite());
  EXPECT_FALSE(before[1].getVector3fMap().allFinite());
  EXPECT_TRUE(before[2].getVector3fMap().allFinite());
}

TEST(PointsBefore, NeedAPoseForEachAndViews)
{
  LayeredScene scene = makeViewedRoom();
  EXPECT_EQ(layersBefore(scene), (Layers{SceneLayer::Points, SceneLayer::Trajectory}));
  for (PCLPointField& field : scene.points.fields)
    if (field.name == "view")
      field.name = "seen";
  EXPECT_EQ(layersBefore(scene), Layers{SceneLayer::Trajectory});
  EXPECT_THROW(pointsUnder(scene, scene.trajectory_before), BadArgumentException);
  scene.trajectory_before.poses.pop_back();
  EXPECT_TRUE(layersBefore(scene).empty());
}

TEST(PointsBefore, ACloudWithTooFewBytesIsRefused)
{
  LayeredScene scene = makeViewedRoom();
  scene.points.data.resize(scene.points.data.size() - 1);
  EXPECT_THROW(pointsUnder(scene, scene.trajectory_before), BadArgumentException);
}

TEST(WallSteps, AreTheDepthsOfWallsAndTheRest)
{
  TriangleMesh mesh;
  EXPECT_EQ(wallSteps(mesh), 0u);
  mesh.wall_depth = {2, 0};
  EXPECT_EQ(wallSteps(mesh), 3u);
  mesh.wall_depth = {2, TriangleMesh::no_wall};
  EXPECT_EQ(wallSteps(mesh), 3u);
  mesh.wall_depth = {0, 0, TriangleMesh::no_wall};
  EXPECT_EQ(wallSteps(mesh), 0u) << "nothing was divided";
  mesh.wall_depth = {TriangleMesh::no_wall};
  EXPECT_EQ(wallSteps(mesh), 0u);
}

} // namespace
} // namespace pcl::acmap::test
