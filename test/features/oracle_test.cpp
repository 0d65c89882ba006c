#include "closed_meshes.h"
#include "naive_voting.h"
#include "voting_runs.h"

#include <pcl/features/impl/voting_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

VotedNormals
voteByKernel(const VotingMesh& mesh,
             const VotingSettings& settings,
             VotingReport& report)
{
  return voteNormals(
      PointView(&mesh.cloud.front().x, sizeof(PointXYZ), mesh.cloud.size()),
      mesh.faces.triangles,
      SensorView(),
      settings,
      Progress(),
      report);
}

/** Difference between the strongest of the three cases and the second. */
double
leadOfClass(const NaiveVote& vote, const VotingSettings& settings)
{
  const Eigen::Vector3d& l = vote.eigenvalues;
  Eigen::Vector3d cases(l[2] - l[1],
                        settings.creaseWeight() * (l[1] - l[0]),
                        settings.creaseWeight() * settings.cornerWeight() * l[0]);
  std::sort(cases.begin(), cases.end());
  return cases[2] - cases[1];
}

/** Compares well-conditioned values only: directions of distinct eigenvalues. */
void
expectSame(const VotedNormal& found,
           const NaiveVote& wanted,
           double lead,
           std::size_t v)
{
  constexpr double tolerance = 1e-4, apart = 0.02;
  const Eigen::Vector3d& l = wanted.eigenvalues;
  EXPECT_NEAR(found.saliency, l[2] - l[1], tolerance) << v;
  if (lead > tolerance) {
    EXPECT_EQ(found.vertex_class, wanted.vertex_class) << v;
  }
  if (l[2] - l[1] > apart) {
    EXPECT_LT((found.normal.cast<double>() - wanted.normal).norm(), tolerance) << v;
  }
  if (l[1] - l[0] > apart) {
    EXPECT_LT(found.direction.cast<double>().cross(wanted.direction).norm(), tolerance)
        << v;
  }
}

/** If there are too few votes, votes again with twice the radius; not as in Page et
 * al. */
NaiveVote
voteTwice(const VotingMesh& mesh, std::size_t vertex, NaiveVotingSettings settings)
{
  const NaiveVote vote = voteNaively(mesh, vertex, settings);
  settings.radius *= 2;
  return vote.vertex_class == VertexClass::Unknown ? voteNaively(mesh, vertex, settings)
                                                   : vote;
}

void
compareWithNaive(const VotingMesh& mesh, const VotingSettings& settings)
{
  VotingReport report;
  const VotedNormals found = voteByKernel(mesh, settings, report);
  NaiveVotingSettings naive;
  naive.radius = report.radius;
  naive.crease_weight = settings.creaseWeight();
  naive.corner_weight = settings.cornerWeight();
  if (!settings.paper) {
    naive.nearest = std::min(2 * report.sigma, report.radius / 3);
    naive.min_votes = 3;
    naive.is_slanted = true;
  }
  std::size_t classes[4] = {}, votes = 0;
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v) {
    const NaiveVote wanted =
        settings.paper ? voteNaively(mesh, v, naive) : voteTwice(mesh, v, naive);
    ++classes[static_cast<std::size_t>(wanted.vertex_class)];
    votes += wanted.votes;
    if (wanted.vertex_class == VertexClass::Unknown)
      EXPECT_TRUE(std::isnan(found.normals[v].saliency)) << v;
    else
      expectSame(found.normals[v], wanted, leadOfClass(wanted, settings), v);
  }
  EXPECT_EQ(classes[0], report.unknown);
  EXPECT_EQ(classes[1], report.surface);
  EXPECT_EQ(classes[2], report.crease);
  EXPECT_EQ(classes[3], report.corner);
  EXPECT_EQ(votes, report.votes);
  EXPECT_TRUE(settings.paper || report.unknown == 0);
}

TEST(VotingOracle, gentleHills)
{
  for (const double radius : {0.0, 2.2, 4.0}) {
    VotingSettings settings;
    settings.radius = radius;
    compareWithNaive(makeRoughMesh(18, 0.5, 1), settings);
  }
}

TEST(VotingOracle, crumpledMesh)
{
  VotingSettings settings;
  settings.radius = 3.7;
  for (const double eps : {0.5, 2.0, 12.0}) {
    settings.crease_weight = eps;
    settings.corner_weight = eps;
    compareWithNaive(makeRoughMesh(16, 2, 2), settings);
  }
}

TEST(VotingOracle, closedSurfaces)
{
  for (const double radius : {0.0, 0.31, 0.83}) {
    VotingSettings settings;
    settings.radius = radius;
    compareWithNaive(makeSphereMesh(2, 1), settings);
  }
}

/** Weights, classes and votes of Page et al. without ours: with few triangles in reach as
 * well, in which case nobody votes for some vertices. */
TEST(PaperVoting, isPagesAsPrinted)
{
  VotingSettings settings;
  settings.paper = true;
  settings.crease_weight = settings.corner_weight = 2;
  for (const double radius : {0.9, 1.6, 2.5, 4.0}) {
    settings.radius = radius;
    compareWithNaive(makeRoughMesh(14, 0.5, 1), settings);
    compareWithNaive(makeRoughMesh(14, 2, 2), settings);
  }
  for (const double radius : {0.31, 0.83}) {
    settings.radius = radius;
    compareWithNaive(makeSphereMesh(2, 1), settings);
  }
}

TEST(PaperVoting, isThatOfTheClass)
{
  const VotingMesh mesh = makeRoughMesh(14, 2, 2);
  VotingSettings settings;
  settings.paper = true;
  settings.crease_weight = settings.corner_weight = 2;
  settings.radius = 2.5;
  VotingReport report;
  const VotedNormals wanted = voteByKernel(mesh, settings, report);
  const auto voteWith = [&](bool paper_mode) {
    return voteOn(mesh, [&](Voting& voting) {
      voting.setPaperMode(paper_mode);
      voting.setRadiusSearch(2.5);
    });
  };
  const Voted found = voteWith(true);
  EXPECT_EQ(found.report.votes, report.votes);
  for (std::size_t v = 0; v < mesh.cloud.size(); ++v) {
    EXPECT_EQ(found.classOf(v), wanted.normals[v].vertex_class) << v;
    EXPECT_EQ(found.normals[v].curvature, 1 - wanted.normals[v].saliency) << v;
  }
  EXPECT_GT(largestDifference(found, voteWith(false)), 0.01) << "ours is another one";
}

TEST(PaperVoting, weightsThatAreSetStay)
{
  Voting voting;
  voting.setCreaseWeight(5);
  voting.setPaperMode(true);
  EXPECT_EQ(voting.getCreaseWeight(), 5);
  EXPECT_EQ(voting.getCornerWeight(), 2);
  voting.setPaperMode(false);
  EXPECT_EQ(voting.getCornerWeight(), 0.3);
}

TEST(VotingOracle, pathsAreThoseOfALattice)
{
  const VotingMesh mesh = makePlaneMesh(7, 7, 1); // diagonals go up to the right
  const std::vector<double> lengths = pathLengths(mesh, 0);
  EXPECT_DOUBLE_EQ(lengths[6], 6);
  EXPECT_DOUBLE_EQ(lengths[48], 6 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(lengths[10], 2 + std::sqrt(2.0)); // (3, 1)
}

} // namespace
} // namespace pcl::acmap::test
