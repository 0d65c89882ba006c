#include "closed_meshes.h"
#include "voting_runs.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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

/** Votes on the same vertices as rows. */
CloudRows
voteOnRows(const PointCloud<MapPoint>& map,
           const TriangleMesh& faces,
           const std::function<void(NormalVectorVoting<PCLPointCloud2>&)>& set)
{
  const PCLPointCloud2::Ptr rows(new PCLPointCloud2);
  toPCLPointCloud2(map, *rows);
  NormalVectorVoting<PCLPointCloud2> voting;
  voting.setInputCloud(rows);
  voting.setTriangles(faces);
  set(voting);
  CloudRows votes;
  voting.compute(votes);
  return votes;
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

TEST(VotedRows, areTheVotesOfPoints)
{
  const VotingMesh mesh = makeRoughMesh(12, 0.5, 3);
  const PointCloud<MapPoint>::Ptr map = toMap(mesh.cloud);
  const Voted voted = voteOnMap(map, mesh.faces, above_and_below);
  const CloudRows votes = voteOnRows(
      *map, mesh.faces, [](auto& voting) { voting.setViewpoints(above_and_below); });
  PointCloud<Normal> normals;
  fromPCLPointCloud2(votes.copy(), normals);
  ASSERT_EQ(normals.size(), mesh.cloud.size());
  const std::size_t of_class = findField(votes.layout(), "vertex_class")->offset;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Normal &a = normals[v], &b = voted.normals[v];
    EXPECT_TRUE(a.getNormalVector3fMap() == b.getNormalVector3fMap() ||
                std::isnan(b.normal_x))
        << v;
    EXPECT_TRUE(a.curvature == b.curvature || std::isnan(b.curvature)) << v;
    EXPECT_EQ(votes.data()[v * votes.layout().point_step + of_class],
              voted.classes[v].label)
        << v;
  }
}

TEST(VotedRows, pointToTheOneSensorWhateverTheirView)
{
  const VotingMesh mesh = makePlaneMesh(8, 8, 0.1);
  for (const float side : {-3.0F, 3.0F}) {
    const CloudRows votes =
        voteOnRows(*toMap(mesh.cloud), mesh.faces, [&](auto& voting) {
          voting.setSensorOrigin({0, 0, side});
        });
    const PointView normals = normalsOf(votes);
    ASSERT_EQ(normals.size(), mesh.cloud.size());
    for (std::size_t v = 0; v < normals.size(); ++v)
      EXPECT_GT(normals[v].z() * side, 2.999F) << v;
  }
}

TEST(VotedRows, refuseWhatCannotBe)
{
  NormalVectorVoting<PCLPointCloud2> voting;
  CloudRows votes;
  EXPECT_THROW(voting.compute(votes), InitFailedException) << "no cloud";
  voting.setInputCloud(std::make_shared<const PCLPointCloud2>());
  EXPECT_THROW(voting.compute(votes), InitFailedException) << "no coordinates";
  EXPECT_THROW(voting.setSensorOrigin({0, NAN, 0}), BadArgumentException);
  TriangleMesh beyond;
  beyond.triangles = {{0, 1, 900}};
  const VotingMesh mesh = makePlaneMesh(3, 3, 1);
  EXPECT_THROW(voteOnRows(*toMap(mesh.cloud), beyond, [](auto&) {}),
               InitFailedException);
}

} // namespace
} // namespace pcl::acmap::test
