#include "clustering_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/** Runs with normals pointing up and all points used by triangles, in both modes, with
 * and without mesh and source. */
void
clusterInAllWays(const Cloud& cloud, const std::function<void(const Clustered&)>& check)
{
  const auto normals = std::make_shared<PointCloud<Normal>>();
  normals->resize(cloud.size(), Normal(0, 0, 1));
  TriangleMesh mesh;
  for (std::size_t i = 2; i < cloud.size(); ++i) {
    const auto corner = static_cast<std::int32_t>(i);
    mesh.triangles.push_back({corner - 2, corner - 1, corner});
  }
  const Cloud::ConstPtr input = cloud.makeShared();
  for (const bool noise_driven : {true, false})
    for (const bool has_mesh : {true, false})
      for (const bool has_source : {true, false}) {
        Clustering clustering;
        clustering.setInputCloud(input);
        clustering.setInputNormals(normals);
        clustering.setNoiseDriven(noise_driven);
        if (has_mesh)
          clustering.setTriangles(mesh);
        if (has_source)
          clustering.setSourceCloud(input);
        const Clustered found = runClustering(clustering);
        EXPECT_EQ(found.labels.size(), cloud.size());
        EXPECT_EQ(found.source_labels.size(),
                  noise_driven && has_source ? cloud.size() : 0U);
        check(found);
      }
}

void
expectNothing(const Cloud& cloud)
{
  clusterInAllWays(cloud, [&](const Clustered& found) {
    EXPECT_TRUE(found.patches.empty());
    EXPECT_EQ(std::count(found.labels.begin(), found.labels.end(), -1),
              static_cast<std::ptrdiff_t>(cloud.size()));
    EXPECT_FALSE(found.report.remarks.empty()) << "it is said why";
  });
}

/** Only requires that it ends, with finite planes. */
void
expectSane(const Cloud& cloud)
{
  clusterInAllWays(cloud, [&](const Clustered& found) {
    const auto size = static_cast<std::int32_t>(found.patches.size());
    for (const std::int32_t label : found.labels)
      EXPECT_TRUE(label >= -1 && label < size);
    for (const PlanePatch& patch : found.patches) {
      EXPECT_NEAR(patch.coefficients.head<3>().norm(), 1, 1e-6);
      EXPECT_TRUE(patch.coefficients.allFinite());
      EXPECT_TRUE(patch.center.allFinite());
      EXPECT_GE(patch.area, 0);
    }
  });
}

TEST(ClusteringUgly, nothingToFind)
{
  expectNothing({});
  expectNothing(makeRandomBox(1, 1));
  expectNothing(makeRandomBox(2, 1));
  expectNothing(makeRandomBox(7, 1));
  Cloud invalid;
  invalid.resize(100, PointXYZ(nan, nan, infinity));
  expectNothing(invalid);
  expectNothing(makeCoincident(200));
}

TEST(ClusteringUgly, degenerateCloudsEndWell)
{
  expectSane(makeCollinear(200));
  expectSane(makeRandomBox(500, 2));
  expectSane(withOutlier(makeWall(1, 1).cloud, 1e9F));
  for (const float factor : {1e-30F, 1e-15F, 1e15F, 1e19F, 1e30F})
    expectSane(scaled(makeWall(1, 1).cloud, factor));
}

TEST(ClusteringUgly, onePointFarOffTakesNoPrecision)
{
  const VotingMesh door = withNoise(makeDoor(0.2), {0, 0, 1}, 0.001);
  const Clustered wanted = clusterOn(door);
  ASSERT_EQ(wanted.patches.size(), 2U);
  for (const float distance : {1e15F, 1e30F, 3e38F}) {
    VotingMesh with = door;
    with.cloud.push_back({distance, -distance, 1});
    const Clustered found = clusterOn(with);
    ASSERT_EQ(found.patches.size(), 2U) << distance;
    for (std::size_t p = 0; p < 2; ++p) {
      EXPECT_LT((found.patches[p].coefficients - wanted.patches[p].coefficients).norm(),
                1e-9)
          << distance;
      EXPECT_EQ(found.patches[p].support, wanted.patches[p].support) << distance;
    }
  }
}

TEST(ClusteringUgly, pointsTwice)
{
  const VotingMesh wall = makeWall(2, 1.5);
  const Clustered found = clusterOn(together(wall, wall));
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, 2 * wall.cloud.size());
  EXPECT_NEAR(found.patches[0].coefficients[2], 1, 1e-9);
  VotingMesh doubled = wall;
  for (const TriangleMesh::Triangle& triangle : wall.faces.triangles)
    doubled.faces.triangles.push_back(triangle);
  EXPECT_EQ(clusterOn(doubled).patches.size(), 1U);
}

TEST(ClusteringUgly, invalidPointsAreSkippedAndCounted)
{
  for (const float wrong : {nan, infinity, -infinity}) {
    VotingMesh wall = makeWall(3, 2);
    wall.cloud.is_dense = false;
    for (std::size_t i = 0; i < wall.cloud.size(); i += 50)
      wall.cloud[i].y = wrong;
    const Clustered found = clusterOn(wall);
    EXPECT_EQ(found.report.invalid_points, (wall.cloud.size() + 49) / 50);
    ASSERT_EQ(found.patches.size(), 1U);
    EXPECT_NEAR(found.patches[0].coefficients[2], 1, 1e-6);
    for (std::size_t i = 0; i < wall.cloud.size(); i += 50)
      EXPECT_EQ(found.labels[i], -1) << i;
  }
}

TEST(ClusteringUgly, invalidNormalsAreNoHypotheses)
{
  const VotingMesh wall = makeWall(3, 2);
  const auto normals = std::make_shared<PointCloud<Normal>>();
  normals->resize(wall.cloud.size(), Normal(0, 0, 1));
  for (std::size_t i = 0; i < normals->size(); ++i) {
    (*normals)[i].curvature = i % 2 == 0 ? nan : 0.01F;
    if (i % 5 == 0)
      (*normals)[i].normal_z = i % 10 == 0 ? nan : 0;
  }
  const Clustered found = clusterOn(
      wall, [&](Clustering& clustering) { clustering.setInputNormals(normals); });
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_NEAR(found.patches[0].coefficients[2], 1, 1e-6);
  EXPECT_LT(found.report.hypotheses, wall.cloud.size());
  for (Normal& normal : *normals)
    normal.normal_z = 0;
  const Clustered none = clusterOn(
      wall, [&](Clustering& clustering) { clustering.setInputNormals(normals); });
  EXPECT_TRUE(none.patches.empty());
  EXPECT_EQ(none.report.hypotheses, 0U);
  EXPECT_NE(none.report.remarks.back().find("normal"), std::string::npos);
}

/** Such points would join arbitrary planes, and so would their neighbours. */
TEST(ClusteringUgly, unknownCurvaturesComeLast)
{
  const VotingMesh wall = makeCurvedWall(1.5, 0.003);
  const Voted voted = voteOn(wall);
  const auto clusterWith = [&](float unknown) {
    const auto normals = voted.normals.makeShared();
    for (std::size_t i = 0; i < normals->size(); i += 3)
      (*normals)[i].curvature = unknown;
    return clusterOn(wall, [&](Clustering& clustering) {
      clustering.setInputNormals(normals);
      clustering.setNoiseDriven(false);
      clustering.setDistanceThreshold(0.03);
    });
  };
  const Clustered found = clusterWith(nan);
  EXPECT_GT(found.patches.size(), 1U);
  EXPECT_TRUE(areSame(found, clusterWith(infinity)));
}

/** No plane can be fitted to such points; they keep the plane of their seed. */
TEST(ClusteringUgly, pointsOnALineHaveTheirMiddleOnTheirPlane)
{
  for (const std::int32_t points : {2, 3, 20}) {
    PointCloud<PointNormal> cloud;
    TriangleMesh mesh;
    for (std::int32_t i = 0; i < points; ++i) {
      const auto step = static_cast<float>(i);
      cloud.push_back({0.02F * step, 0, 0.001F * step, 0, 0, 1});
      mesh.triangles.push_back({i, i, std::max(i - 1, 0)});
    }
    const Clustered found = clusterAsPaper(cloud, [&](auto& clustering) {
      clustering.setTriangles(mesh);
      clustering.setMinClusterSize(0); // more than no supporter beside the seed
    });
    ASSERT_EQ(found.patches.size(), 1U) << points;
    const PlanePatch& patch = found.patches[0];
    EXPECT_NEAR(patch.coefficients.head<3>().dot(patch.center) + patch.coefficients[3],
                0,
                1e-12)
        << points;
  }
}

TEST(ClusteringUgly, wrongTrianglesEndWell)
{
  VotingMesh wall = makeWall(2, 1.5);
  for (std::int32_t v = 0; v + 300 < 1271; v += 7) {
    wall.faces.triangles.push_back({v, v, v});
    wall.faces.triangles.push_back({v, v, v + 1});
    wall.faces.triangles.push_back({v, v + 200, v + 300}); // crossing the others
  }
  const Clustered found = clusterOn(wall);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_NEAR(found.patches[0].coefficients[2], 1, 1e-6);
}

TEST(ClusteringUgly, invalidSourcePointsHaveNoPlane)
{
  const VotingMesh wall = makeWall(3, 2);
  const Cloud::Ptr source = lacedWithNan(wall.cloud, 4).makeShared();
  const Clustered found = clusterOn(
      wall, [&](Clustering& clustering) { clustering.setSourceCloud(source); });
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, wall.cloud.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < source->size(); ++i)
    wrong += (found.source_labels[i] >= 0) != (*source)[i].getVector3fMap().allFinite();
  EXPECT_EQ(wrong, 0U);
}

} // namespace
} // namespace pcl::acmap::test
