#include "voting_runs.h"

#include <pcl/core/random.h>
#include <pcl/features/impl/voting_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

/** Smooth hills, so that the normal of every vertex is well defined. */
VotingMesh
makeHills(int side)
{
  return makeRoughMesh(side, 0.4, 7);
}

VotingMesh
withMixedTriangles(VotingMesh mesh, std::uint64_t seed)
{
  Random random(seed);
  auto& triangles = mesh.faces.triangles;
  for (std::size_t i = triangles.size(); i > 1; --i)
    std::swap(
        triangles[i - 1],
        triangles[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
  for (TriangleMesh::Triangle& triangle : triangles)
    std::rotate(triangle.begin(),
                triangle.begin() + static_cast<int>(random.uniform() * 3),
                triangle.end());
  return mesh;
}

std::size_t
differentClasses(const Voted& a, const Voted& b)
{
  std::size_t different = 0;
  for (std::size_t v = 0; v < a.classes.size(); ++v)
    different += a.classes[v].label != b.classes[v].label;
  return different;
}

TEST(VotingInvariance, threadsDoNotChangeAByte)
{
  const VotingMesh mesh = makeHills(280);
  const auto vote = [&](unsigned threads) {
    VotingSettings settings;
    settings.compute_curvatures = true;
    settings.threads = threads;
    VotingReport report;
    return voteNormals(
        PointView(&mesh.cloud.front().x, sizeof(PointXYZ), mesh.cloud.size()),
        mesh.faces.triangles,
        SensorView(),
        settings,
        Progress(),
        report);
  };
  const VotedNormals alone = vote(1);
  for (const unsigned threads : {2U, 8U}) {
    const VotedNormals found = vote(threads);
    std::size_t different = 0;
    for (std::size_t v = 0; v < mesh.cloud.size(); ++v) {
      const VotedNormal &a = alone.normals[v], &b = found.normals[v];
      different += a.normal != b.normal || a.direction != b.direction ||
                   a.saliency != b.saliency || a.vertex_class != b.vertex_class ||
                   std::memcmp(&alone.curvatures[v],
                               &found.curvatures[v],
                               sizeof(VotedCurvature)) != 0;
    }
    EXPECT_EQ(different, 0U) << threads << " threads";
  }
}

TEST(VotingInvariance, orderOfTheTrianglesDoesNotMatter)
{
  const VotingMesh mesh = makeHills(40);
  const Voted voted = voteOn(mesh);
  const Voted mixed = voteOn(withMixedTriangles(mesh, 5));
  EXPECT_LT(largestDifference(voted, mixed), 1e-5);
  EXPECT_LE(differentClasses(voted, mixed), 1U);
  EXPECT_EQ(voted.report.radius, mixed.report.radius);
}

TEST(VotingInvariance, motionTurnsTheNormals)
{
  const VotingMesh mesh = makeHills(40);
  const auto setRadius = [](Voting& voting) { voting.setRadiusSearch(3.1); };
  const Voted voted = voteOn(mesh, setRadius);
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Eigen::Isometry3d motion = makeRandomMotion(seed, 10);
    VotingMesh there = mesh;
    there.cloud = moved(mesh.cloud, motion);
    Voted found = voteOn(there, setRadius);
    for (Normal& normal : found.normals)
      normal.getNormalVector3fMap() =
          motion.linear().cast<float>().transpose() * normal.getNormalVector3fMap();
    EXPECT_LT(largestDifference(voted, found), 1e-4);
    EXPECT_LE(differentClasses(voted, found), 2U);
  }
}

TEST(VotingInvariance, scaleDoesNotMatter)
{
  const VotingMesh mesh = makeHills(40);
  const Voted voted = voteOn(mesh);
  for (const float factor : {1e-4F, 1e4F}) {
    VotingMesh there = mesh;
    there.cloud = scaled(mesh.cloud, factor);
    const Voted found = voteOn(there);
    EXPECT_NEAR(found.report.radius / voted.report.radius / double{factor}, 1, 1e-3);
    EXPECT_LT(largestDifference(voted, found), 1e-3);
    EXPECT_LE(differentClasses(voted, found), 4U);
  }
}

/** Coordinates of a national grid: floats are multiples of 6 cm there, but the centre
 * of a triangle is not. */
TEST(VotingInvariance, farFromTheOriginIsAsGood)
{
  for (const double slope : {0.25, 1.0, 3.0})
    for (const double far : {0.0, 1e6}) {
      const VotingMesh mesh = makeSheetMesh(21, 21, 1, [=](double u, double v) {
        return Eigen::Vector3d(far + u, far + v, far + slope * u);
      });
      const Voted voted = voteOn(mesh);
      EXPECT_EQ(voted.report.surface, mesh.cloud.size());
      const Eigen::Vector3f normal =
          Eigen::Vector3d(-slope, 0, 1).normalized().cast<float>();
      for (std::size_t v = 0; v < mesh.cloud.size(); ++v)
        EXPECT_LT((voted.normal(v) - normal).norm(), 1e-5F)
            << v << ", slope " << slope << ", at " << far;
    }
}

} // namespace
} // namespace pcl::acmap::test
