#include "clustering_runs.h"
#include "map_points.h"

#include <pcl/conversions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_types.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>

#include <gtest/gtest.h>

#ifdef ACMAP_FEW_POINT_TYPES
#include <pcl/segmentation/impl/plane_hypothesis_clustering.hpp>
#endif

#include <algorithm>

namespace pcl::acmap::test {
namespace {

template <typename PointT>
class AnyPointClusters : public testing::Test {};

TYPED_TEST_SUITE(AnyPointClusters, MapPoints);

TYPED_TEST(AnyPointClusters, theSame)
{
  const VotingMesh mesh = withNoise(makeDoor(0.2), {0, 0, 1}, 0.001);
  const Voted voted = voteOn(mesh);
  PlaneHypothesisClustering<TypeParam> clustering;
  clustering.setInputCloud(copyOf<TypeParam>(mesh.cloud));
  clustering.setInputNormals(voted.normals.makeShared());
  clustering.setVertexClasses(voted.classes.makeShared());
  clustering.setTriangles(mesh.faces);
  const Clustered found = runClustering(clustering);
  EXPECT_GE(found.patches.size(), 2U);
  EXPECT_TRUE(areSame(found, clusterOn(mesh)));
}

/** A cloud with normals of any length. */
CloudRows
rowsOf(const VotingMesh& mesh, const Voted& voted)
{
  PointCloud<PointNormal> cloud = *copyOf<PointNormal>(mesh.cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud[i].getNormalVector3fMap() = 3 * voted.normal(i);
  const PCLPointCloud2::Ptr rows(new PCLPointCloud2);
  toPCLPointCloud2(cloud, *rows);
  return rows;
}

/** The votes as NormalVectorVoting<PCLPointCloud2> returns them. */
CloudRows
rowsOf(const Voted& voted)
{
  const PCLPointCloud2::Ptr normals(new PCLPointCloud2);
  toPCLPointCloud2(voted.normals, *normals);
  return rowsWith(CloudRows(normals),
                  {{"vertex_class", PCLPointField::UINT8}},
                  [&](std::uint8_t* row, std::size_t i) {
                    row[normals->point_step] =
                        static_cast<std::uint8_t>(voted.classes[i].label);
                  });
}

TEST(ClusteringClass, takesRows)
{
  const VotingMesh mesh = withNoise(makeDoor(0.2), {0, 0, 1}, 0.001);
  const Voted voted = voteOn(mesh);
  PlaneHypothesisClustering<PCLPointCloud2> clustering;
  clustering.setInputCloud(rowsOf(mesh, voted));
  clustering.setTriangles(mesh.faces);
  EXPECT_GE(runClustering(clustering).patches.size(), 2U) << "their own normals";
  clustering.setInputNormals(rowsOf(voted));
  EXPECT_TRUE(areSame(runClustering(clustering), clusterOn(mesh)));
  clustering.setNoiseDriven(false);
  EXPECT_GT(clustering.estimateSeconds(), 0);
}

TEST(ClusteringClass, refusesRowsThatDoNotFit)
{
  const VotingMesh mesh = makeWall(1, 1);
  const Voted voted = voteOn(mesh);
  PlaneHypothesisClustering<PCLPointCloud2> clustering;
  CylinderHypothesisClustering<PCLPointCloud2> cylinders;
  std::vector<PlanePatch> planes;
  std::vector<CylinderPatch> patches;
  EXPECT_EQ(clustering.estimateSeconds(), 0);
  EXPECT_THROW(clustering.segment(planes), InitFailedException) << "no cloud";
  EXPECT_THROW(cylinders.segment(patches), InitFailedException);
  const PCLPointCloud2::Ptr bare(new PCLPointCloud2);
  toPCLPointCloud2(mesh.cloud, *bare);
  clustering.setInputCloud(bare);
  EXPECT_THROW(clustering.segment(planes), InitFailedException) << "no normals";
  clustering.setInputCloud(rowsOf(mesh, voted));
  cylinders.setInputCloud(rowsOf(mesh, voted));
  const CloudRows others = rowsOf(voteOn(makeWall(1, 2)));
  clustering.setInputNormals(others);
  cylinders.setInputNormals(others);
  EXPECT_THROW(clustering.segment(planes), InitFailedException) << "too many normals";
  EXPECT_THROW(cylinders.segment(patches), InitFailedException);
  TriangleMesh beyond;
  beyond.triangles = {{0, 1, 100000}};
  clustering.setInputNormals(rowsOf(voted));
  clustering.setTriangles(beyond);
  EXPECT_THROW(clustering.segment(planes), InitFailedException) << "corners";
}

TEST(ClusteringClass, takesTheNormalsOfThePoints)
{
  const VotingMesh mesh = withNoise(makeDoor(0.2), {0, 0, 1}, 0.001);
  const Voted voted = voteOn(mesh);
  const auto cloud = copyOf<PointNormal>(mesh.cloud);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*cloud)[i].getNormalVector3fMap() = 3 * voted.normal(i); // of any length
  PlaneHypothesisClustering<PointNormal> clustering;
  clustering.setInputCloud(cloud);
  clustering.setTriangles(mesh.faces);
  const Clustered found = runClustering(clustering);
  ASSERT_GE(found.patches.size(), 2U);
  EXPECT_NEAR(distanceFrom(found.patches[0], {0, 0, 0}), 0, 0.001);
  EXPECT_NEAR(distanceFrom(found.patches[1], {0, 0, -0.2}), 0, 0.001);
}

TEST(ClusteringClass, polygonsAreFans)
{
  const VotingMesh mesh = makeWall(2, 1.5);
  std::vector<Vertices> polygons;
  for (const TriangleMesh::Triangle& triangle : mesh.faces.triangles) {
    polygons.emplace_back();
    polygons.back().vertices.assign(triangle.begin(), triangle.end());
  }
  polygons.emplace_back(); // not a face
  const Clustered found = clusterOn(
      mesh, [&](Clustering& clustering) { clustering.setTriangles(polygons); });
  EXPECT_TRUE(areSame(found, clusterOn(mesh)));
}

TEST(ClusteringClass, indicesChooseHypotheses)
{
  const VotingMesh mesh = makeBoards(0.12);
  const auto chosen = std::make_shared<Indices>();
  for (std::size_t i = mesh.cloud.size() / 2; i < mesh.cloud.size(); ++i)
    chosen->push_back(static_cast<index_t>(i));
  const auto setIndices = [&](Clustering& clustering) {
    clustering.setIndices(chosen);
  };
  const Clustered found = clusterOn(mesh, setIndices);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_NEAR(distanceFrom(found.patches[0], {0, 0, 0.12}), 0, 1e-6);
  ASSERT_EQ(found.labels.size(), mesh.cloud.size()) << "of the whole cloud";
  EXPECT_EQ(found.report.hypotheses, chosen->size());
  for (std::size_t i = 0; i < found.labels.size(); ++i)
    EXPECT_EQ(found.labels[i], i < mesh.cloud.size() / 2 ? -1 : 0) << i;
}

/** The other points are on the same wall, but are not selected. */
TEST(ClusteringClass, indicesPartAWall)
{
  const VotingMesh mesh = withNoise(makeWall(3, 2), {0, 0, 1}, 0.002);
  const auto chosen = std::make_shared<Indices>();
  for (std::size_t i = mesh.cloud.size(); i-- > 0;)
    if (mesh.cloud[i].x < 0)
      chosen->insert(chosen->end(), 2, static_cast<index_t>(i)); // duplicated
  for (const bool has_mesh : {true, false})
    for (const bool noise_driven : {true, false}) {
      const Clustered found = clusterOn(mesh, [&](Clustering& clustering) {
        clustering.setIndices(chosen);
        clustering.setNoiseDriven(noise_driven);
        clustering.setClusterTolerance(10);
        if (!has_mesh)
          clustering.setTriangles(TriangleMesh());
      });
      ASSERT_EQ(found.patches.size(), 1U);
      EXPECT_EQ(found.report.points, chosen->size() / 2);
      EXPECT_NEAR(found.patches[0].area, has_mesh ? 3 : 0, 0.25);
      EXPECT_NEAR(found.patches[0].center.x(), -0.75, 0.06);
      for (std::size_t i = 0; i < mesh.cloud.size(); ++i)
        EXPECT_TRUE(mesh.cloud[i].x < 0 || found.labels[i] < 0) << i;
    }
}

TEST(ClusteringClass, noIndicesChooseNothing)
{
  const Clustered found = clusterOn(makeWall(1, 1), [](Clustering& clustering) {
    clustering.setIndices(std::make_shared<Indices>());
  });
  EXPECT_TRUE(found.patches.empty());
  EXPECT_EQ(found.labels, PointLabels(441, -1));
}

TEST(ClusteringClass, extractGivesThePointsOfEachPlane)
{
  const VotingMesh mesh = makeBoards(0.12);
  Clustering clustering;
  setMesh(clustering, mesh);
  const Cloud::Ptr cloud = mesh.cloud.makeShared();
  cloud->header.frame_id = "map";
  clustering.setInputCloud(cloud);
  std::vector<PointIndices> clusters;
  clustering.extract(clusters);
  ASSERT_EQ(clusters.size(), 2U);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(clusters[p].header.frame_id, "map");
    EXPECT_EQ(clusters[p].indices.size(), mesh.cloud.size() / 2);
    EXPECT_TRUE(std::is_sorted(clusters[p].indices.begin(), clusters[p].indices.end()));
    for (const index_t index : clusters[p].indices)
      EXPECT_EQ(clustering.getLabels()[static_cast<std::size_t>(index)],
                static_cast<std::int32_t>(p));
  }
}

TEST(ClusteringClass, distanceThresholdIsAutomaticWhereNoiseDecides)
{
  Clustering clustering;
  EXPECT_FALSE(clustering.getDistanceThreshold()) << "automatic";
  clustering.setDistanceThreshold(0.07);
  EXPECT_EQ(clustering.getDistanceThreshold(), 0.07);
  clustering.setNoiseDriven(false);
  EXPECT_EQ(clustering.getDistanceThreshold(), 0.07);
}

TEST(ClusteringClass, givenDistanceIsUsedInBothModes)
{
  for (const bool noise_driven : {true, false}) {
    const Clustered found = clusterOn(makeBoards(0.12), [&](Clustering& clustering) {
      clustering.setNoiseDriven(noise_driven);
      clustering.setClusterTolerance(10);
      clustering.setDistanceThreshold(0.07);
    });
    EXPECT_EQ(found.report.plane_distance, 0.07);
    EXPECT_EQ(found.patches.size(), 2U);
  }
}

TEST(ClusteringClass, sourceMayBeForgotten)
{
  Clustering clustering;
  setMesh(clustering, makeWall(1, 1));
  {
    const Cloud::ConstPtr source = makeWall(1, 1).cloud.makeShared();
    clustering.setSourceCloud(source);
  } // the object keeps a reference
  EXPECT_EQ(runClustering(clustering).source_labels.size(), 441U);
  const Cloud::Ptr variable = makeWall(1, 1).cloud.makeShared();
  clustering.setSourceCloud(variable);
  EXPECT_EQ(runClustering(clustering).source_labels.size(), 441U);
  clustering.setSourceCloud(Cloud::ConstPtr());
  EXPECT_TRUE(runClustering(clustering).source_labels.empty());
  const Cloud::ConstPtr empty(new Cloud);
  clustering.setSourceCloud(empty);
  EXPECT_EQ(runClustering(clustering).patches.size(), 1U);
}

} // namespace
} // namespace pcl::acmap::test
