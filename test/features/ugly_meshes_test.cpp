#include "voting_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

void
askForCurvatures(Voting& voting)
{
  voting.setComputeCurvatures(true);
}

/** Expects that there were no votes for the vertex. */
void
expectUnknown(const Voted& voted, std::size_t v)
{
  for (const float value : voted.normals[v].normal)
    EXPECT_TRUE(std::isnan(value)) << v;
  EXPECT_TRUE(std::isnan(voted.normals[v].curvature)) << v;
  EXPECT_EQ(voted.classOf(v), VertexClass::Unknown) << v;
  EXPECT_TRUE(std::isnan(voted.curvatures[v].pc1)) << v;
  EXPECT_TRUE(std::isnan(voted.curvatures[v].pc2)) << v;
}

/** Expects that all vertices are unknown, with a remark that says why. */
void
expectNothing(const VotingMesh& mesh)
{
  const Voted voted = voteOn(mesh, askForCurvatures);
  ASSERT_EQ(voted.normals.size(), mesh.cloud.size());
  EXPECT_EQ(voted.report.vertices, mesh.cloud.size());
  EXPECT_EQ(voted.report.unknown, mesh.cloud.size());
  EXPECT_EQ(voted.normals.is_dense, mesh.cloud.empty());
  EXPECT_FALSE(voted.report.remarks.empty());
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
    expectUnknown(voted, v);
}

TEST(VotingUgly, noTriangles)
{
  expectNothing({});
  expectNothing({makeRandomBox(1, 1), {}});
  expectNothing({makeJitteredPlane({10, 10, 0.1, 0.25, 0, 1}).cloud, {}});
}

TEST(VotingUgly, tooFewTriangles)
{
  TriangleMesh faces;
  faces.triangles = {{0, 1, 1}};
  expectNothing({makeRandomBox(2, 1), faces});
  faces.triangles = {{0, 1, 2}};
  expectNothing({makeRandomBox(3, 1), faces});
  faces.triangles = {{0, 1, 2}, {2, 1, 3}};
  expectNothing({makeRandomBox(4, 1), faces});
}

TEST(VotingUgly, trianglesWithoutArea)
{
  for (const Cloud& cloud : {makeCoincident(30), makeCollinear(30)}) {
    VotingMesh mesh{cloud, {}};
    for (std::int32_t v = 2; v < 30; ++v)
      mesh.faces.triangles.push_back({v - 2, v - 1, v});
    const Voted voted = voteOn(mesh);
    EXPECT_EQ(voted.report.degenerate_triangles + voted.report.surface +
                  voted.report.crease + voted.report.corner,
              28U)
        << "rounding may leave some an area";
    if (cloud[0].getVector3fMap() == cloud[1].getVector3fMap())
      expectNothing(mesh);
  }
}

TEST(VotingUgly, degenerateTrianglesHaveNoSay)
{
  const VotingMesh mesh = makeRoughMesh(15, 0.4, 1);
  VotingMesh laced = mesh;
  for (std::int32_t v = 0; v + 100 < 225; v += 3)
    laced.faces.triangles.insert(laced.faces.triangles.begin() + 2 * v,
                                 {{v, v, v + 100}, {v + 100, v, v + 100}, {v, v, v}});
  const Voted voted = voteOn(laced);
  EXPECT_EQ(largestDifference(voted, voteOn(mesh)), 0);
  EXPECT_EQ(voted.report.degenerate_triangles, 3U * 42);
}

TEST(VotingUgly, doubledTrianglesVoteTwice)
{
  const VotingMesh mesh = makeRoughMesh(15, 0.4, 1);
  VotingMesh doubled = mesh;
  doubled.faces.triangles.insert(doubled.faces.triangles.end(),
                                 mesh.faces.triangles.begin(),
                                 mesh.faces.triangles.end());
  EXPECT_LT(largestDifference(voteOn(doubled), voteOn(mesh)), 1e-5);
}

TEST(VotingUgly, invalidPointsTakeTheirTrianglesWithThem)
{
  const VotingMesh mesh = makePlaneMesh(20, 20, 0.1);
  for (const float wrong : {nan, infinity, -infinity}) {
    VotingMesh laced = mesh;
    laced.cloud.is_dense = false;
    for (std::size_t v = 0; v < laced.cloud.size(); v += 7)
      laced.cloud[v].z = wrong;
    const Voted voted = voteOn(laced, askForCurvatures);
    EXPECT_EQ(voted.report.invalid_points, 58U);
    EXPECT_GT(voted.report.degenerate_triangles, 200U);
    EXPECT_FALSE(voted.normals.is_dense);
    for (std::size_t v = 0; v < laced.cloud.size(); ++v)
      if (v % 7 == 0)
        expectUnknown(voted, v);
      else if (voted.classOf(v) != VertexClass::Unknown) {
        EXPECT_GT(voted.normals[v].normal_z, 0.9999F) << v;
      }
    EXPECT_LT(voted.report.unknown, 58U + 20);
  }
}

TEST(VotingUgly, isolatedVerticesAreUnknownAndHarmNobody)
{
  const VotingMesh mesh = makeRoughMesh(15, 0.4, 1);
  VotingMesh larger = mesh;
  larger.cloud += makeRandomBox(9, 1);
  const auto set = [](Voting& voting) {
    voting.setRadiusSearch(3);
    voting.setComputeCurvatures(true);
  };
  Voted voted = voteOn(larger, set);
  EXPECT_EQ(voted.report.unknown, 9U);
  for (std::size_t v = mesh.cloud.size(); v < larger.cloud.size(); ++v)
    expectUnknown(voted, v);
  voted.normals.resize(mesh.cloud.size());
  EXPECT_LT(largestDifference(voted, voteOn(mesh, set)), 1e-5);
}

TEST(VotingUgly, hugeAndTinyCoordinatesEndWell)
{
  const VotingMesh mesh = makeRoughMesh(10, 0.4, 1);
  for (const float factor : {1e-30F, 1e-15F, 1e15F, 1e19F, 1e30F, 3e37F}) {
    VotingMesh there = mesh;
    there.cloud = scaled(mesh.cloud, factor);
    const Voted voted = voteOn(there, askForCurvatures);
    for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
      if (voted.classOf(v) != VertexClass::Unknown) {
        EXPECT_NEAR(voted.normal(v).norm(), 1, 1e-4) << v << ", " << factor;
      }
      else
        expectUnknown(voted, v);
  }
}

TEST(VotingUgly, outlierInTheMeshIsForgotten)
{
  VotingMesh mesh = makePlaneMesh(20, 20, 0.1);
  mesh.cloud[210].z = 1e9F;
  const Voted voted = voteOn(mesh, [](Voting& voting) { voting.setRadiusSearch(0.3); });
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
    if (v != 210) {
      EXPECT_GT(voted.normals[v].normal_z, 0.9999F) << v;
    }
}

TEST(VotingUgly, radiusBelowTheEdgesLeavesNothing)
{
  const VotingMesh mesh = makePlaneMesh(10, 10, 1);
  const Voted small = voteOn(mesh, [](Voting& voting) { voting.setRadiusSearch(0.1); });
  EXPECT_EQ(small.report.unknown, 100U);
  EXPECT_FALSE(small.report.remarks.empty());
  const Voted large = voteOn(mesh, [](Voting& voting) { voting.setRadiusSearch(1e9); });
  EXPECT_EQ(large.report.surface, 100U) << "all vote";
}

} // namespace
} // namespace pcl::acmap::test
