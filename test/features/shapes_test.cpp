#include "closed_meshes.h"
#include "voting_runs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

double
angleBetween(const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

void
askForCurvatures(Voting& voting)
{
  voting.setComputeCurvatures(true);
}

/** The vertices whose neighbourhood is a complete disc. */
std::vector<std::size_t>
withWholeDisc(const VotingMesh& mesh, const Voted& voted)
{
  const std::vector<bool> is_inner = innerVertices(mesh);
  std::vector<std::size_t> chosen;
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v) {
    bool is_clear = true;
    for (std::size_t other = 0; other < mesh.cloud.size() && is_clear; ++other)
      is_clear =
          is_inner[other] ||
          (mesh.cloud[other].getVector3fMap() - mesh.cloud[v].getVector3fMap()).norm() >
              voted.report.radius;
    if (is_clear)
      chosen.push_back(v);
  }
  return chosen;
}

TEST(VotedShapes, planeIsExactUpToItsRim)
{
  const VotingMesh mesh = makePlaneMesh(30, 20, 0.25);
  const Voted voted = voteOn(mesh, askForCurvatures);
  EXPECT_NEAR(voted.report.radius, 2.5 * voted.report.mean_edge, 1e-9);
  EXPECT_EQ(voted.report.surface, mesh.cloud.size());
  EXPECT_TRUE(voted.normals.is_dense);
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v) {
    EXPECT_LT(angleBetween(voted.normal(v), {0, 0, 1}), 1e-6) << v;
    EXPECT_LT(std::abs(voted.normals[v].curvature), 1e-5) << v;
    EXPECT_EQ(voted.classOf(v), VertexClass::Surface) << v;
    EXPECT_LT(std::abs(voted.curvatures[v].pc1), 1e-5) << v;
    EXPECT_LT(std::abs(voted.curvatures[v].pc2), 1e-5) << v;
  }
}

TEST(VotedShapes, inclinedPlaneIsExact)
{
  const Eigen::Vector3f normal = Eigen::Vector3f(-1, -2, 3).normalized();
  const VotingMesh mesh = makeSheetMesh(20, 20, 0.25, [](double u, double v) {
    return Eigen::Vector3d(u, v, (u + 2 * v) / 3);
  });
  const Voted voted = voteOn(mesh);
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
    EXPECT_LT(angleBetween(voted.normal(v), normal), 1e-5) << v;
}

TEST(VotedShapes, sphereHasTwoEqualCurvatures)
{
  constexpr double radius = 2;
  const VotingMesh mesh = makeSphereMesh(4, radius);
  for (const double side : {1.0, -1.0}) {
    const Voted voted = voteOn(side > 0 ? mesh : turnedOver(mesh), askForCurvatures);
    EXPECT_EQ(voted.report.surface, mesh.cloud.size());
    for (std::size_t v = 0; v < mesh.cloud.size(); ++v) {
      const Eigen::Vector3f outwards = mesh.cloud[v].getVector3fMap().normalized();
      EXPECT_LT(angleBetween(voted.normal(v), static_cast<float>(side) * outwards),
                0.3 * degree)
          << v;
      EXPECT_NEAR(voted.curvatures[v].pc1, side / radius, 0.03 / radius) << v;
      EXPECT_NEAR(voted.curvatures[v].pc2, side / radius, 0.03 / radius) << v;
    }
  }
}

TEST(VotedShapes, cylinderBendsRoundItsAxisAlone)
{
  constexpr double radius = 0.5;
  const VotingMesh mesh = makeHalfCylinderMesh(40, radius);
  for (const double side : {1.0, -1.0}) {
    const Voted voted = voteOn(side > 0 ? mesh : turnedOver(mesh), askForCurvatures);
    const std::vector<std::size_t> inner = withWholeDisc(mesh, voted);
    ASSERT_GT(inner.size(), 500U);
    for (const std::size_t v : inner) {
      Eigen::Vector3f outwards = mesh.cloud[v].getVector3fMap();
      outwards.y() = 0;
      EXPECT_LT(angleBetween(voted.normal(v),
                             static_cast<float>(side) * outwards.normalized()),
                0.3 * degree)
          << v;
      const PrincipalCurvatures& curvatures = voted.curvatures[v];
      EXPECT_NEAR(curvatures.pc1, side / radius, 0.05 / radius) << v;
      EXPECT_NEAR(curvatures.pc2, 0, 0.05 / radius) << v;
      const Eigen::Map<const Eigen::Vector3f> along(curvatures.principal_curvature);
      EXPECT_NEAR(along.norm(), 1, 1e-5) << v;
      EXPECT_LT(std::abs(along.y()), 0.05) << "it runs round the axis, " << v;
      EXPECT_LT(std::abs(along.dot(voted.normal(v))), 1e-5) << v;
    }
  }
}

TEST(VotedShapes, saddleBendsBothWays)
{
  constexpr double radius = 4;
  const VotingMesh mesh = makeSheetMesh(21, 21, 0.05, [](double u, double v) {
    return Eigen::Vector3d(u, v, (u * u - v * v) / (2 * radius));
  });
  const Voted voted = voteOn(mesh, askForCurvatures);
  const std::size_t middle = mesh.cloud.size() / 2;
  EXPECT_LT(angleBetween(voted.normal(middle), {0, 0, 1}), 0.1 * degree);
  const PrincipalCurvatures& curvatures = voted.curvatures[middle];
  const double along_v = std::abs(curvatures.principal_curvature[1]) > 0.7
                             ? curvatures.pc1
                             : curvatures.pc2;
  EXPECT_NEAR(along_v, 1 / radius, 0.05 / radius) << "the normal tips outwards";
  EXPECT_NEAR(curvatures.pc1 + curvatures.pc2, 0, 0.05 / radius);
}

/** All votes come from one side and are less accurate, because a helix is not a
 * circular arc. */
TEST(VotedShapes, rimsOfOpenMeshesHaveNormals)
{
  const VotingMesh mesh = makeHalfCylinderMesh(20, 0.5);
  const Voted voted = voteOn(mesh);
  const std::vector<bool> is_inner = innerVertices(mesh);
  EXPECT_EQ(voted.report.unknown, 0U);
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
    if (!is_inner[v]) {
      Eigen::Vector3f outwards = mesh.cloud[v].getVector3fMap();
      outwards.y() = 0;
      EXPECT_LT(angleBetween(voted.normal(v), outwards), 4 * degree) << v;
    }
}

} // namespace
} // namespace pcl::acmap::test
