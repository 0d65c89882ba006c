#include "closed_meshes.h"
#include "voting_runs.h"

#include <pcl/core/point_types.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using MapPoint = PointXYZRGBNormalView;

const std::vector<Eigen::Vector3f> above_and_below = {{0, 0, 5}, {0, 0, -5}};

/** Points left of x = 0 were observed from above, the others from below. */
PointCloud<MapPoint>::Ptr
toMap(const Cloud& cloud)
{
  const auto map = std::make_shared<PointCloud<MapPoint>>();
  for (const PointXYZ& place : cloud) {
    MapPoint point;
    point.getVector3fMap() = place.getVector3fMap();
    point.view = place.x < 0 ? 0 : 1;
    map->push_back(point);
  }
  return map;
}

Voted
voteOnMap(const PointCloud<MapPoint>::Ptr& map,
          const TriangleMesh& faces,
          const std::vector<Eigen::Vector3f>& viewpoints)
{
  NormalVectorVoting<MapPoint> voting;
  voting.setInputCloud(map);
  voting.setTriangles(faces);
  voting.setViewpoints(viewpoints);
  voting.setComputeCurvatures(true);
  return runVoting(voting);
}

TEST(VotedSides, areThoseOfTheFaces)
{
  const VotingMesh mesh = makePlaneMesh(20, 20, 0.1);
  const Voted above = voteOn(mesh);
  const Voted below = voteOn(turnedOver(mesh));
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v) {
    EXPECT_GT(above.normals[v].normal_z, 0.9999F) << v;
    EXPECT_LT(below.normals[v].normal_z, -0.9999F) << v;
  }
}

TEST(VotedSides, originOfTheCloudIsNoSensorThatSomebodyNamed)
{
  VotingMesh mesh = makePlaneMesh(20, 20, 0.1);
  mesh.cloud.sensor_origin_ = Eigen::Vector4f(0, 0, -3, 1);
  EXPECT_GT(voteOn(mesh).normals[0].normal_z, 0.9999F);
}

TEST(VotedSides, areTheViewpointsEvenOfFacesThatAreTurnedWrongly)
{
  const VotingMesh mesh = makePlaneMesh(20, 20, 0.1);
  VotingMesh mixed = mesh;
  for (std::size_t t = 0; t < mixed.faces.triangles.size(); t += 3)
    std::swap(mixed.faces.triangles[t][0], mixed.faces.triangles[t][1]);
  for (const TriangleMesh& faces : {mesh.faces, turnedOver(mesh).faces, mixed.faces}) {
    const Voted voted = voteOnMap(toMap(mesh.cloud), faces, above_and_below);
    for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
      EXPECT_GT(voted.normals[v].normal_z * (mesh.cloud[v].x < 0 ? 1 : -1), 0.9999F)
          << v;
  }
}

TEST(VotedSides, pointsOfNoKnownViewKeepThatOfTheFaces)
{
  const VotingMesh mesh = makePlaneMesh(20, 20, 0.1);
  const auto map = toMap(mesh.cloud);
  for (MapPoint& point : *map)
    point.view = point.y < 0 ? -1 : 7;
  for (const Voted& voted :
       {voteOnMap(map, mesh.faces, above_and_below), voteOnMap(map, mesh.faces, {})})
    for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
      EXPECT_GT(voted.normals[v].normal_z, 0.9999F) << v;
}

TEST(VotedSides, curvatureHasTheSignOfTheSide)
{
  const VotingMesh mesh = makeSphereMesh(3, 1);
  const auto map = toMap(mesh.cloud);
  for (MapPoint& point : *map)
    point.view = 0;
  for (const TriangleMesh& faces : {mesh.faces, turnedOver(mesh).faces}) {
    const Voted voted = voteOnMap(map, faces, {{0, 0, 0}});
    for (const PrincipalCurvatures& curvatures : voted.curvatures) {
      EXPECT_NEAR(curvatures.pc1, -1, 0.1) << "seen from the middle";
      EXPECT_NEAR(curvatures.pc2, -1, 0.1) << "seen from the middle";
    }
  }
}

} // namespace
} // namespace pcl::acmap::test
