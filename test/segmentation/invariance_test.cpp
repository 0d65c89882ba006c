#include "clustering_runs.h"
#include "room_planes.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace pcl::acmap::test {
namespace {

/** Wall, door, and a distant board. */
VotingMesh
makeSample()
{
  return withNoise(
      together(makeDoor(0.2), placedAt(makeWall(1, 1), 5, 0, 1)), {0, 0, 1}, 0.001);
}

/** Requires similar coefficients, areas and supports, in the order of the patches. */
void
expectAgreement(const std::vector<PlanePatch>& found,
                const std::vector<PlanePatch>& wanted,
                double scale = 1)
{
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t p = 0; p < found.size(); ++p) {
    const Eigen::Vector4d &a = found[p].coefficients, &b = wanted[p].coefficients;
    EXPECT_LT((a.head<3>() - b.head<3>()).norm(), 2e-4) << p;
    EXPECT_NEAR(a[3] / scale, b[3], 2e-3) << p;
    EXPECT_NEAR(found[p].area / (scale * scale), wanted[p].area, 0.03) << p;
    EXPECT_NEAR(static_cast<double>(found[p].support),
                static_cast<double>(wanted[p].support),
                0.01 * static_cast<double>(wanted[p].support) + 2)
        << p;
    EXPECT_NEAR(found[p].rms / scale, wanted[p].rms, 0.02 * wanted[p].rms) << p;
  }
}

TEST(ClusteringInvariance, motionMovesThePlanes)
{
  const VotingMesh mesh = makeSample();
  const std::vector<PlanePatch> wanted = clusterOn(mesh).patches;
  ASSERT_EQ(wanted.size(), 3U);
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Eigen::Isometry3d motion = makeRandomMotion(seed, 5);
    VotingMesh there = mesh;
    there.cloud = moved(mesh.cloud, motion);
    std::vector<PlanePatch> found = clusterOn(there).patches;
    for (PlanePatch& patch : found) {
      const Eigen::Vector3d normal =
          motion.linear().transpose() * patch.coefficients.head<3>();
      patch.coefficients[3] += patch.coefficients.head<3>().dot(motion.translation());
      patch.coefficients.head<3>() = normal;
    }
    expectAgreement(found, wanted);
  }
}

TEST(ClusteringInvariance, scaleDoesNotMatter)
{
  const VotingMesh mesh = makeSample();
  const std::vector<PlanePatch> wanted = clusterOn(mesh).patches;
  for (const float factor : {0.01F, 4.0F, 1000.0F}) {
    VotingMesh there = mesh;
    there.cloud = scaled(mesh.cloud, factor);
    const Clustered found = clusterOn(there, [&](Clustering& clustering) {
      clustering.setMinArea(0.1 * factor * factor);
      clustering.setDistanceThreshold(0.006 * factor);
    });
    expectAgreement(found.patches, wanted, factor);
  }
}

TEST(ClusteringInvariance, orderOfThePointsDoesNotMatter)
{
  const VotingMesh mesh = makeSample();
  const std::vector<PlanePatch> wanted = clusterOn(mesh).patches;
  for (const std::uint64_t seed : {1, 2, 3}) {
    std::vector<std::int32_t> places(mesh.cloud.size());
    std::iota(places.begin(), places.end(), 0);
    Random random(seed);
    for (std::size_t i = places.size(); i > 1; --i)
      std::swap(places[i - 1], places[random.bits() % i]);
    VotingMesh mixed = mesh;
    for (std::size_t i = 0; i < places.size(); ++i)
      mixed.cloud[static_cast<std::size_t>(places[i])] = mesh.cloud[i];
    for (TriangleMesh::Triangle& triangle : mixed.faces.triangles)
      for (std::int32_t& corner : triangle)
        corner = places[static_cast<std::size_t>(corner)];
    std::reverse(mixed.faces.triangles.begin(), mixed.faces.triangles.end());
    expectAgreement(clusterOn(mixed).patches, wanted);
  }
}

TEST(ClusteringInvariance, threadsAndRunsDoNotChangeAByte)
{
  const SeenRoom room = see(makeRoomWithDoor(0.01, 0.2), 1);
  const RoomPlanes wanted = findPlanes(room);
  EXPECT_GE(wanted.patches.size(), 6U);
  for (const unsigned threads : {1U, 2U, 8U, 1U})
    EXPECT_TRUE(areSame(
        findPlanes(room,
                   [&](auto& clustering) { clustering.setNumberOfThreads(threads); }),
        wanted))
        << threads << " threads";
}

TEST(ClusteringInvariance, paperModeDoesNotDependOnThreadsOrRuns)
{
  const VotingMesh mesh = makeSample();
  const auto setPaperMode = [](unsigned threads) {
    return [=](Clustering& clustering) {
      clustering.setNoiseDriven(false);
      clustering.setNumberOfThreads(threads);
    };
  };
  const Clustered wanted = clusterOn(mesh, setPaperMode(1));
  for (const unsigned threads : {1U, 2U, 8U})
    EXPECT_TRUE(areSame(clusterOn(mesh, setPaperMode(threads)), wanted));
}

TEST(ClusteringInvariance, runsDoNotDependOnEarlierOnes)
{
  const VotingMesh first = makeSample(), second = makeThinWall(0.12);
  Clustering clustering;
  for (const VotingMesh& mesh : {first, second, first}) {
    setMesh(clustering, mesh);
    EXPECT_TRUE(areSame(runClustering(clustering), clusterOn(mesh)));
  }
}

/** Coordinates of a national grid: floats are multiples of 6 cm there. */
TEST(ClusteringInvariance, farFromTheOriginIsAsGood)
{
  const auto makeBoardsAt = [](double far) {
    const VotingMesh board = makeSheetMesh(31, 31, 1, [=](double u, double v) {
      return Eigen::Vector3d(far + u, far + v, far + u / 4);
    });
    return together(board, placedAt(board, 0, 0, 5));
  };
  const auto planesAt = [&](double far) { // the boards are equally large
    std::vector<PlanePatch> patches = clusterOn(makeBoardsAt(far)).patches;
    std::sort(patches.begin(), patches.end(), [](const auto& a, const auto& b) {
      return a.center.z() < b.center.z();
    });
    return patches;
  };
  const std::vector<PlanePatch> wanted = planesAt(0), found = planesAt(1e6);
  ASSERT_EQ(wanted.size(), 2U);
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_LT((found[p].coefficients - wanted[p].coefficients).head<3>().norm(), 1e-6);
    EXPECT_NEAR(found[p].area, wanted[p].area, 0.2);
    EXPECT_LT(
        (found[p].center - wanted[p].center - Eigen::Vector3d::Constant(1e6)).norm(),
        1e-3);
    EXPECT_NEAR(distanceFrom(found[p], found[p].center), 0, 1e-6);
    EXPECT_EQ(found[p].polygons.size(), 1U);
  }
}

} // namespace
} // namespace pcl::acmap::test
