#include "clustering_runs.h"

#include <pcl/core/exceptions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

TEST(ClusteringRefusals, wrongSettingsAreRefused)
{
  Clustering clustering;
  for (const double wrong : {0.0, -0.1, 1e10, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_THROW(clustering.setClusterTolerance(wrong), BadArgumentException) << wrong;
    EXPECT_THROW(clustering.setSmoothnessThreshold(wrong), BadArgumentException)
        << wrong;
    EXPECT_THROW(clustering.setDistanceThreshold(wrong), BadArgumentException) << wrong;
  }
  EXPECT_THROW(clustering.setSmoothnessThreshold(1.6), BadArgumentException);
  for (const double wrong : {-0.1, std::nan(""), HUGE_VAL})
    EXPECT_THROW(clustering.setMinArea(wrong), BadArgumentException) << wrong;
  const Cloud::ConstPtr source = makeWall(1, 1).cloud.makeShared();
  EXPECT_THROW(
      clustering.setSourceCloud(source, {{static_cast<float>(HUGE_VAL), 0, 0}}),
      BadArgumentException);
  EXPECT_EQ(clustering.getClusterTolerance(), 0.8);
  EXPECT_FALSE(clustering.getDistanceThreshold()); // by the noise
  clustering.setNoiseDriven(false);
  EXPECT_EQ(clustering.getDistanceThreshold(), 0.25);
}

void
expectRefused(const std::function<void(Clustering&)>& spoil, const std::string& word)
{
  Clustering clustering;
  setMesh(clustering, makeWall(1, 1));
  spoil(clustering);
  std::vector<PlanePatch> patches(3);
  EXPECT_THAT([&] { clustering.segment(patches); },
              testing::ThrowsMessage<InitFailedException>(testing::HasSubstr(word)))
      << word;
  EXPECT_EQ(patches.size(), 3U) << "untouched";
  std::vector<PointIndices> clusters(2);
  EXPECT_THROW(clustering.extract(clusters), InitFailedException);
  EXPECT_EQ(clusters.size(), 2U);
}

TEST(ClusteringRefusals, wrongInputsAreRefused)
{
  expectRefused([](Clustering& c) { c = Clustering(); }, "no input cloud");
  expectRefused([](Clustering& c) { c.setInputNormals(nullptr); }, "no normals");
  expectRefused(
      [](Clustering& c) {
        c.setInputNormals(std::make_shared<PointCloud<Normal>>(3, 1));
      },
      "3 normals");
  expectRefused(
      [](Clustering& c) {
        c.setVertexClasses(std::make_shared<PointCloud<Label>>(5, 1));
      },
      "5 vertex classes");
  for (const index_t wrong : {-1, 441, 1 << 30}) {
    expectRefused(
        [&](Clustering& c) {
          c.setIndices(std::make_shared<Indices>(Indices{0, wrong}));
        },
        "index");
    TriangleMesh mesh;
    mesh.triangles = {{0, 1, 2}, {3, 4, wrong}};
    expectRefused([&](Clustering& c) { c.setTriangles(mesh); }, "corner");
  }
}

TEST(ClusteringRefusals, cancelLeavesEverythingAsItWas)
{
  Clustering clustering;
  setMesh(clustering, makeBoards(0.12));
  const Cloud::ConstPtr source = makeBoards(0.12).cloud.makeShared();
  clustering.setSourceCloud(source);
  const Clustered before = runClustering(clustering);
  for (int allowed = 0; allowed < 20; ++allowed) {
    int calls = 0;
    clustering.setProgressCallback(
        [&](double, const std::string&) { return calls++ < allowed; });
    std::vector<PlanePatch> patches(7);
    try {
      clustering.segment(patches);
      EXPECT_EQ(patches.size(), 2U);
      EXPECT_GE(allowed, 4) << "it is told now and then";
      return;
    }
    catch (const CancelledException&) {
      EXPECT_EQ(patches.size(), 7U);
      EXPECT_EQ(clustering.getLabels(), before.labels);
      EXPECT_EQ(clustering.getSourceLabels(), before.source_labels);
      EXPECT_EQ(clustering.getReport().planes, before.report.planes);
    }
  }
  ADD_FAILURE() << "never finished";
}

} // namespace
} // namespace pcl::acmap::test
