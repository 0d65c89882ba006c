#include "map_points.h"
#include "voting_runs.h"

#include <pcl/PolygonMesh.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/point_types.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef ACMAP_FEW_POINT_TYPES
#include <pcl/features/impl/normal_vector_voting.hpp>
#endif

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

template <typename PointT>
class AnyPointVotes : public testing::Test {};

TYPED_TEST_SUITE(AnyPointVotes, MapPoints);

TYPED_TEST(AnyPointVotes, theSame)
{
  const VotingMesh mesh = makeRoughMesh(12, 0.5, 3);
  const auto cloud = copyOf<TypeParam>(mesh.cloud);
  cloud->header.frame_id = "map";
  cloud->header.stamp = 77;
  cloud->width = cloud->height = 12;
  NormalVectorVoting<TypeParam> voting;
  voting.setInputCloud(cloud);
  voting.setTriangles(mesh.faces);
  const Voted voted = runVoting(voting);
  EXPECT_EQ(largestDifference(voted, voteOn(mesh)), 0);
  EXPECT_EQ(voted.normals.header.frame_id, "map");
  EXPECT_EQ(voted.normals.header.stamp, 77U);
  EXPECT_EQ(voted.normals.width, 12U) << "organized as the cloud";
  EXPECT_TRUE(voted.curvatures.empty()) << "nobody asked";
}

TEST(VotingClass, polygonsAreFans)
{
  const VotingMesh plane = makePlaneMesh(3, 3, 1);
  PolygonMesh polygons; // a pentagon, a square, a triangle, and an invalid face
  for (const Indices& corners :
       std::vector<Indices>{{1, 2, 5, 4, 0}, {3, 4, 7, 6}, {4, 5, 8}, {1, 2}, {}}) {
    polygons.polygons.emplace_back();
    polygons.polygons.back().vertices = corners;
  }
  TriangleMesh fans;
  fans.triangles = {{1, 2, 5}, {1, 5, 4}, {1, 4, 0}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}};
  Voting voting;
  voting.setInputCloud(plane.cloud.makeShared());
  voting.setTriangles(polygons.polygons);
  EXPECT_EQ(voting.getTriangles(), fans.triangles);
  const Voted voted = runVoting(voting);
  voting.setTriangles(fans);
  EXPECT_EQ(largestDifference(voted, runVoting(voting)), 0);
  EXPECT_EQ(voted.report.triangles, 6U);
  for (std::size_t v = 0; v < 9; ++v)
    EXPECT_EQ(voted.normal(v), Eigen::Vector3f(0, 0, 1)) << v;
}

TEST(VotingClass, indicesChooseVerticesAndNotTriangles)
{
  const VotingMesh mesh = makeRoughMesh(12, 0.5, 4);
  const auto askForCurvatures = [](Voting& voting) {
    voting.setComputeCurvatures(true);
  };
  const Voted whole = voteOn(mesh, askForCurvatures);
  const Indices chosen = {7, 140, 3, 3, 80};
  const Voted some = voteOn(mesh, [&](Voting& voting) {
    askForCurvatures(voting);
    voting.setIndices(std::make_shared<Indices>(chosen));
  });
  ASSERT_EQ(some.normals.size(), chosen.size());
  ASSERT_EQ(some.classes.size(), chosen.size());
  ASSERT_EQ(some.curvatures.size(), chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(chosen[i]);
    EXPECT_EQ(some.normal(i), whole.normal(vertex));
    EXPECT_EQ(some.normals[i].curvature, whole.normals[vertex].curvature);
    EXPECT_EQ(some.classes[i].label, whole.classes[vertex].label);
    if (!std::isnan(whole.curvatures[vertex].pc1)) {
      EXPECT_EQ(some.curvatures[i].pc1, whole.curvatures[vertex].pc1);
    }
  }
}

TEST(VotingClass, wrongSettingsAreRefused)
{
  Voting voting;
  for (const double wrong : {-0.1, -1e-300, 2e9, std::nan(""), HUGE_VAL, -HUGE_VAL})
    EXPECT_THROW(voting.setRadiusSearch(wrong), BadArgumentException) << wrong;
  for (const double wrong : {0.0, -2.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(voting.setCreaseWeight(wrong), BadArgumentException) << wrong;
    EXPECT_THROW(voting.setCornerWeight(wrong), BadArgumentException) << wrong;
  }
  for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e10})
    EXPECT_THROW(voting.setViewpoints({{0, 0, 0}, {1, static_cast<float>(wrong), 2}}),
                 BadArgumentException)
        << wrong;
  EXPECT_EQ(voting.getRadiusSearch(), 0);
  EXPECT_EQ(voting.getCreaseWeight(), 12);
  EXPECT_EQ(voting.getCornerWeight(), 0.3);
  EXPECT_TRUE(voting.getViewpoints().empty());
}

TEST(VotingClass, wrongInputIsRefusedAndOutputUntouched)
{
  const VotingMesh mesh = makePlaneMesh(4, 4, 1);
  PointCloud<Normal> output;
  output.resize(3);
  Voting voting;
  voting.setTriangles(mesh.faces);
  EXPECT_THROW(voting.compute(output), InitFailedException) << "no cloud";
  voting.setInputCloud(mesh.cloud.makeShared());
  for (const index_t wrong : {-1, 16}) {
    voting.setIndices(std::make_shared<Indices>(Indices{0, wrong}));
    EXPECT_THROW(voting.compute(output), InitFailedException) << "index " << wrong;
    voting.setIndices(std::make_shared<Indices>(Indices{0, 1}));
    TriangleMesh faces = mesh.faces;
    faces.triangles.push_back({0, 1, wrong});
    voting.setTriangles(faces);
    EXPECT_THAT([&] { voting.compute(output); },
                testing::ThrowsMessage<InitFailedException>(
                    testing::AllOf(testing::HasSubstr(std::to_string(wrong)),
                                   testing::HasSubstr("16 points"))))
        << "corner " << wrong;
    voting.setTriangles(mesh.faces);
  }
  EXPECT_EQ(output.size(), 3U);
  voting.compute(output);
  EXPECT_EQ(output.size(), 2U) << "it works after all";
}

TEST(VotingClass, progressNeverFallsAndStopsAtAnyCall)
{
  const VotingMesh mesh = makeRoughMesh(12, 0.5, 5);
  Voting voting;
  voting.setInputCloud(mesh.cloud.makeShared());
  voting.setTriangles(mesh.faces);
  voting.setComputeCurvatures(true);
  int calls = 0;
  double last = 0;
  voting.setProgressCallback([&](double fraction, const std::string& step) {
    EXPECT_GE(fraction, last) << step;
    EXPECT_LE(fraction, 1) << step;
    last = fraction;
    return ++calls > 0;
  });
  const Voted whole = runVoting(voting);
  EXPECT_EQ(last, 1);
  ASSERT_GT(calls, 20);
  for (int allowed = 0; allowed < calls; ++allowed) {
    Voted output = whole;
    output.normals.resize(3);
    voting.setProgressCallback(
        [left = allowed](double, const std::string&) mutable { return left-- > 0; });
    EXPECT_THROW(voting.compute(output.normals), CancelledException) << allowed;
    EXPECT_EQ(output.normals.size(), 3U) << allowed;
  }
  PointCloud<Label> classes;
  voting.getVertexClasses(classes);
  EXPECT_EQ(classes.size(), mesh.cloud.size()) << "those of the last whole run";
}

TEST(VotingClass, radiusAndNoiseAreTold)
{
  const VotingMesh mesh = makePlaneMesh(30, 30, 0.5);
  const Voted voted =
      voteOn(mesh, [](Voting& voting) { voting.setRadiusSearch(1.25); });
  EXPECT_EQ(voted.report.radius, 1.25);
  EXPECT_EQ(voted.report.vertices, 900U);
  EXPECT_EQ(voted.report.triangles, 2U * 29 * 29);
  EXPECT_GT(voted.report.mean_edge, 0.5);
  EXPECT_LT(voted.report.mean_edge, 0.5 * 1.4143);
  EXPECT_EQ(voted.report.sigma, 0) << "a plane without noise";
  EXPECT_TRUE(voted.report.remarks.empty());
}

} // namespace
} // namespace pcl::acmap::test
