#include "closed_meshes.h"
#include "voting_runs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

TEST(VotedCreases, roofHasOneAlongItsRidge)
{
  for (const double angle : {60.0, 90.0, 120.0, 145.0}) {
    const VotingMesh mesh = makeRoofMesh(angle * degree);
    const Voted voted = voteOn(mesh);
    const std::vector<Eigen::Vector3f> directions = creaseDirections(mesh);
    for (std::size_t v = 0; v < mesh.cloud.size(); ++v) {
      const double edges_off = std::abs(mesh.cloud[v].x) / std::sin(angle / 2 * degree);
      if (edges_off < 0.5) {
        EXPECT_EQ(voted.classOf(v), VertexClass::Crease) << angle << " at " << v;
        EXPECT_GT(std::abs(directions[v].y()), 0.999F) << angle << " at " << v;
      }
      else if (edges_off > 1.5) {
        EXPECT_EQ(voted.classOf(v), VertexClass::Surface)
            << angle << ", " << edges_off << " edges off, at " << v;
      }
    }
  }
}

TEST(VotedCreases, flatRoofHasNone)
{
  for (const double angle : {160.0, 170.0, 180.0}) {
    const VotingMesh mesh = makeRoofMesh(angle * degree);
    EXPECT_EQ(voteOn(mesh).report.surface, mesh.cloud.size()) << angle;
  }
}

/** On the ridge, sin^2 phi = 1 / (2 + eps) for an angle of 2 phi between the
 * normals. */
TEST(VotedCreases, weightSaysFromWhichAngleOn)
{
  for (const double eps : {2.0, 5.0, 12.0, 30.0}) {
    const double turn = 2 * std::asin(1 / std::sqrt(2 + eps));
    for (const double off : {-2 * degree, 2 * degree}) {
      const VotingMesh mesh = makeRoofMesh(M_PI - turn - off);
      const Voted voted =
          voteOn(mesh, [&](Voting& voting) { voting.setCreaseWeight(eps); });
      const std::size_t on_the_ridge = mesh.cloud.size() / 2;
      EXPECT_EQ(voted.classOf(on_the_ridge),
                off > 0 ? VertexClass::Crease : VertexClass::Surface)
          << "weight " << eps << ", turn " << (turn + off) / degree;
    }
  }
}

TEST(VotedCreases, roofOf150DegreesWithALargerWeight)
{
  const VotingMesh mesh = makeRoofMesh(150 * degree);
  const Voted voted = voteOn(mesh, [](Voting& voting) { voting.setCreaseWeight(16); });
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
    EXPECT_EQ(voted.classOf(v),
              std::abs(mesh.cloud[v].x) < 0.5 ? VertexClass::Crease
                                              : VertexClass::Surface)
        << v;
}

TEST(VotedCreases, normalsBesideThemAreThoseOfTheirSide)
{
  const VotingMesh mesh = makeRoofMesh(90 * degree);
  const Voted voted = voteOn(mesh);
  const auto half = static_cast<float>(std::sqrt(0.5));
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
    if (std::abs(mesh.cloud[v].x) > 1.8F) { // 2.5 edges
      const Eigen::Vector3f normal(mesh.cloud[v].x > 0 ? half : -half, 0, half);
      EXPECT_GT(voted.normal(v).dot(normal), 0.99999F) << v;
    }
}

TEST(VotedCreases, cubeHasEightCorners)
{
  constexpr int side = 12;
  const VotingMesh mesh = makeCubeMesh(side, 0.1);
  const Voted voted = voteOn(mesh);
  const std::vector<Eigen::Vector3f> directions = creaseDirections(mesh);
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v) {
    const Eigen::Vector3f place = mesh.cloud[v].getVector3fMap() / 0.6F;
    std::vector<int> edge_axes; // axes along which the vertex is not at an end
    float nearest_end = 2;      // distance to an edge or corner, in halves of the cube
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(place[axis]) < 0.99F) {
        edge_axes.push_back(axis);
        nearest_end = std::min(nearest_end, 1 - std::abs(place[axis]));
      }
    const bool is_clear = nearest_end > 1.5F / (side / 2);
    if (edge_axes.empty()) {
      EXPECT_EQ(voted.classOf(v), VertexClass::Corner) << place.transpose();
    }
    else if (edge_axes.size() == 1) {
      EXPECT_NE(voted.classOf(v), VertexClass::Surface) << place.transpose();
      if (nearest_end > 3.0F / (side / 2)) {
        EXPECT_EQ(voted.classOf(v), VertexClass::Crease) << place.transpose();
        EXPECT_GT(std::abs(directions[v][edge_axes[0]]), 0.999F) << place.transpose();
      }
    }
    else if (is_clear) {
      EXPECT_EQ(voted.classOf(v), VertexClass::Surface) << place.transpose();
    }
  }
}

TEST(VotedCreases, cornerWeightDecidesBetweenCreaseAndCorner)
{
  const VotingMesh mesh = makeCubeMesh(8, 0.1);
  const auto corners = [&](double eta) {
    return voteOn(mesh, [&](Voting& voting) { voting.setCornerWeight(eta); })
        .report.corner;
  };
  EXPECT_GE(corners(0.3), 8U);
  EXPECT_LE(corners(1e-6), 8U);
  EXPECT_GT(corners(5), corners(0.3));
}

TEST(VotedCreases, curvaturesAreToldOffThemAlone)
{
  const VotingMesh mesh = makeRoofMesh(90 * degree);
  const Voted voted =
      voteOn(mesh, [](Voting& voting) { voting.setComputeCurvatures(true); });
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
    EXPECT_EQ(std::isnan(voted.curvatures[v].pc1),
              voted.classOf(v) != VertexClass::Surface)
        << v;
}

} // namespace
} // namespace pcl::acmap::test
