#include "clustering_runs.h"

#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

using PaperClustering = PlaneHypothesisClustering<PointNormal>;
using Hypotheses = PointCloud<PointNormal>;

PointNormal
hypothesis(const Eigen::Vector3d& place, const Eigen::Vector3d& normal)
{
  PointNormal point;
  point.getVector3fMap() = place.cast<float>();
  point.getNormalVector3fMap() = normal.normalized().cast<float>();
  return point;
}

/** Adds points on z = 0, all within W_d of each other unless the step is large. */
void
addGrid(Hypotheses& cloud,
        int columns,
        int rows,
        double x,
        const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ(),
        double step = 0.02)
{
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      cloud.push_back(hypothesis({x + step * column, step * row, 0}, normal));
}

std::size_t
planesOf(const Hypotheses& cloud)
{
  return clusterAsPaper(cloud).patches.size();
}

/** The support of the only plane. */
std::size_t
supportOf(const Hypotheses& cloud, std::size_t minimum = 50)
{
  const Clustered found = clusterAsPaper(cloud, [&](PaperClustering& clustering) {
    clustering.setMinClusterSize(minimum);
  });
  EXPECT_EQ(found.patches.size(), 1U);
  return found.patches.empty() ? 0 : found.patches[0].support;
}

TEST(PaperMode, thresholdsAreThePapers)
{
  PaperClustering clustering;
  EXPECT_TRUE(clustering.getNoiseDriven()) << "the default is ours";
  clustering.setNoiseDriven(false);
  EXPECT_DOUBLE_EQ(clustering.getClusterTolerance(), 0.8);
  EXPECT_DOUBLE_EQ(clustering.getSmoothnessThreshold(), M_PI / 8);
  EXPECT_EQ(clustering.getDistanceThreshold(), 0.25);
  EXPECT_EQ(clustering.getMinClusterSize(), 50U);
  const PlaneClusteringSettings settings;
  EXPECT_TRUE(settings.noise_driven);
  EXPECT_EQ(settings.member_distance, clustering.getClusterTolerance());
  EXPECT_NEAR(settings.normal_angle, clustering.getSmoothnessThreshold(), 1e-8);
  EXPECT_FALSE(settings.plane_distance) << "of the mode";
  EXPECT_EQ(paper_plane_distance, clustering.getDistanceThreshold());
  EXPECT_EQ(settings.min_support, clustering.getMinClusterSize());
  Hypotheses cloud;
  addGrid(cloud, 10, 10, 0);
  EXPECT_EQ(clusterAsPaper(cloud).report.plane_distance, 0.25);
}

/** The hypothesis does not support itself. */
TEST(PaperMode, moreThanFiftySupporters)
{
  Hypotheses cloud;
  addGrid(cloud, 17, 3, 0);
  const Clustered refused = clusterAsPaper(cloud);
  EXPECT_EQ(refused.patches.size(), 0U);
  EXPECT_EQ(refused.report.tested_hypotheses, 51U) << "each one";
  ASSERT_FALSE(refused.report.remarks.empty());
  EXPECT_NE(refused.report.remarks.back().find("no planes"), std::string::npos);
  cloud.push_back(hypothesis({0, 0.06, 0}, {0, 0, 1}));
  const Clustered found = clusterAsPaper(cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, 52U) << "with the hypothesis";
  EXPECT_EQ(found.report.tested_hypotheses, 1U);
  EXPECT_EQ(found.report.reestimations, 51U) << "with each supporter";
  EXPECT_EQ(
      clusterAsPaper(
          cloud, [](PaperClustering& clustering) { clustering.setMinClusterSize(51); })
          .patches.size(),
      0U);
}

/** II-C.2 (ii): supporters are near one that was considered before as part of the plane, and
 * a wall is whole. */
TEST(PaperMode, distanceIsToAnyMember)
{
  for (const double x : {1.17, 1.19}) { // the last column is at 0.38
    Hypotheses cloud;
    addGrid(cloud, 20, 3, 0);
    cloud.push_back(hypothesis({x, 0, 0}, {0, 0, 1}));
    EXPECT_EQ(supportOf(cloud), x < 1.18 ? 61U : 60U) << x;
  }
  Hypotheses wall;
  addGrid(wall, 200, 20, 0, {0, 0, 1}, 0.05);
  EXPECT_EQ(supportOf(wall), wall.size());
}

/** The other reading, (i) alone: supporters are near the hypothesis, and one wall comes as many
 * planes. */
TEST(PaperMode, distanceIsToTheHypothesisIfAskedFor)
{
  const auto to_hypothesis = [](PaperClustering& clustering) {
    clustering.setSupporterReach(SupporterReach::Hypothesis);
  };
  for (const double x : {0.79, 0.81}) {
    Hypotheses cloud;
    addGrid(cloud, 20, 3, 0);
    cloud.push_back(hypothesis({x, 0, 0}, {0, 0, 1}));
    const Clustered found = clusterAsPaper(cloud, to_hypothesis);
    ASSERT_EQ(found.patches.size(), 1U);
    EXPECT_EQ(found.patches[0].support, x < 0.8 ? 61U : 60U) << x;
  }
  Hypotheses wall;
  addGrid(wall, 200, 20, 0, {0, 0, 1}, 0.05);
  const Clustered found = clusterAsPaper(wall, to_hypothesis);
  EXPECT_GE(found.patches.size(), 7U);
  EXPECT_EQ(found.report.merged, 0U);
  std::vector<double> minimum(found.patches.size(), 1e9), maximum(minimum.size(), -1e9);
  for (std::size_t i = 0; i < wall.size(); ++i)
    if (found.labels[i] >= 0) {
      const auto plane = static_cast<std::size_t>(found.labels[i]);
      minimum[plane] = std::min(minimum[plane], double{wall[i].x});
      maximum[plane] = std::max(maximum[plane], double{wall[i].x});
    }
  for (std::size_t p = 0; p < minimum.size(); ++p)
    EXPECT_LT(maximum[p] - minimum[p], 1.6);
}

TEST(PaperMode, normalsDifferByLessThanAnEighthOfPi)
{
  for (const double angle : {22.0, 23.0, 90.0, 158.0, 180.0}) {
    Hypotheses groups;
    addGrid(groups, 8, 5, 0);
    addGrid(groups, 8, 5, 0.3, {std::sin(angle * degree), 0, std::cos(angle * degree)});
    EXPECT_EQ(planesOf(groups), angle < 22.5 ? 1U : 0U) << angle;
  }
}

/** The plane's own normal, which the points determine, is that of the others. */
TEST(PaperMode, normalsAreComparedWithThatOfTheHypothesis)
{
  const auto tilted = [](double angle) {
    return hypothesis({0.1, 0.1, 0},
                      {std::sin(angle * degree), 0, std::cos(angle * degree)});
  };
  for (const double angle : {22.0, 23.0}) {
    Hypotheses cloud;
    cloud.push_back(tilted(angle));
    addGrid(cloud, 10, 10, 0);
    EXPECT_EQ(supportOf(cloud), angle < 22.5 ? 101U : 100U) << angle;
  }
  // The last one is 20 degrees from the hypothesis and 35 from the plane, or 25 and 10.
  for (const double angle : {35.0, -10.0}) {
    Hypotheses cloud;
    cloud.push_back(tilted(15));
    addGrid(cloud, 10, 10, 0);
    cloud.push_back(tilted(angle));
    EXPECT_EQ(supportOf(cloud), angle > 0 ? 102U : 101U) << angle;
  }
}

/** The normal says which side of a wall is seen, wherever the camera is. */
TEST(PaperMode, planeFacesWhereItsHypothesisDoes)
{
  for (const double side : {1.0, -1.0}) {
    Hypotheses cloud;
    addGrid(cloud, 10, 10, 0, {0, 0, side});
    const Clustered found = clusterAsPaper(cloud);
    ASSERT_EQ(found.patches.size(), 1U);
    EXPECT_GT(side * found.patches[0].coefficients[2], 0.9999);
  }
}

TEST(PaperMode, distanceToThePlaneIsLessThanAQuarterMetre)
{
  for (const double height : {0.24, 0.26, -0.24, -0.26}) {
    Hypotheses cloud;
    addGrid(cloud, 27, 27, 0);
    cloud.push_back(hypothesis({0.26, 0.26, height}, {0, 0, 1}));
    EXPECT_EQ(supportOf(cloud), std::abs(height) < 0.25 ? 730U : 729U) << height;
  }
}

/** Points within W_t with other normals are not added, neither at the border nor far
 * from it. */
TEST(PaperMode, nearnessAloneIsNoSupport)
{
  Hypotheses cloud;
  addGrid(cloud, 27, 27, 0);
  for (int k = 0; k < 20; ++k) {
    cloud.push_back(hypothesis({0.1 + 0.02 * k, 0.2, 0.1}, {1, 0, 0}));
    cloud.push_back(hypothesis({0.1 + 0.02 * k, 0.6, 0.2}, {0, 0, -1}));
    cloud.push_back(hypothesis({0.1 + 0.02 * k, 0.3, 0}, {0, 1, 0}));
  }
  const Clustered found = clusterAsPaper(cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, 729U);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_EQ(found.labels[i], i < 729 ? 0 : -1) << i;
}

/** The far end of the slope is farther than W_t from the plane of the hypothesis. */
TEST(PaperMode, planeFollowsItsSupporters)
{
  Hypotheses cloud;
  for (int step = 0; step < 25; ++step)
    for (int k = 0; k < 6; ++k)
      cloud.push_back(hypothesis({0.03 * step, 0.02 * k, 0.012 * step}, {0, 0, 1}));
  const Clustered found = clusterAsPaper(cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, cloud.size());
  EXPECT_LT(angleFrom(found.patches[0], {-0.4, 0, 1}), 0.01 * degree);
}

/** The third of the points determines the plane on which the last one lies. */
TEST(PaperMode, everySupporterMovesThePlane)
{
  for (const bool is_last : {true, false}) {
    Hypotheses cloud;
    cloud.push_back(hypothesis({0, 0, 0}, {0, 0, 1}));
    cloud.push_back(hypothesis({0.2, 0.3, 0.24}, {0, 0, 1}));
    cloud.push_back(hypothesis({0.2, 0, 0.24}, {0, 0, 1}));
    const PointNormal far = hypothesis({0.5, 0, 0.6}, {0, 0, 1});
    cloud.insert(is_last ? cloud.end() : cloud.begin() + 1, far);
    EXPECT_EQ(supportOf(cloud, 2), 4U) << "wherever it is in the order";
  }
}

/** A supporter stays, although the plane moves away from it. */
TEST(PaperMode, nothingIsRemoved)
{
  Hypotheses cloud;
  cloud.push_back(hypothesis({0, 0, 0}, {0, 0, 1}));
  cloud.push_back(hypothesis({0, 0.7, 0.24}, {0, 0, 1}));
  for (int k = 0; k < 400; ++k) {
    const double x = 0.028 * (k % 20), y = 0.028 * (k / 20);
    cloud.push_back(hypothesis({x, y, -0.1 * y}, {0, 0, 1}));
  }
  const Clustered found = clusterAsPaper(cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, 402U);
  EXPECT_GT(distanceFrom(found.patches[0], {0, 0.7, 0.24}), 0.26);
}

/** Neighbours in the mesh that lie on the plane, but have another normal, join planes
 * that are noise-driven. */
TEST(PaperMode, rimsAndStragglersAreNotAdded)
{
  const VotingMesh wall = makeWall(1, 1);
  const auto normals = std::make_shared<PointCloud<Normal>>();
  std::size_t inner = 0;
  for (const PointXYZ& point : wall.cloud) {
    const bool is_rim = std::abs(point.x) > 0.46F;
    inner += is_rim ? 0 : 1;
    normals->push_back(is_rim ? Normal(1, 0, 0) : Normal(0, 0, 1));
  }
  for (const bool noise_driven : {true, false}) {
    const Clustered found = clusterOn(wall, [&](Clustering& clustering) {
      clustering.setInputNormals(normals);
      clustering.setNoiseDriven(noise_driven);
      clustering.setClusterTolerance(2);
    });
    ASSERT_EQ(found.patches.size(), 1U);
    EXPECT_EQ(leftOut(found), noise_driven ? 0U : wall.cloud.size() - inner);
  }
}

TEST(PaperMode, thresholdsCanBeSet)
{
  Hypotheses cloud; // two boards, 10 cm apart in depth
  addGrid(cloud, 20, 20, 0, {0, 0, 1}, 0.015);
  for (int k = 0; k < 400; ++k)
    cloud.push_back(
        hypothesis({0.3 + 0.015 * (k % 20), 0.015 * (k / 20), -0.1}, {0, 0, 1}));
  EXPECT_EQ(planesOf(cloud), 1U) << "the paper's W_t swallows it";
  const auto setTighter = [](PaperClustering& clustering) {
    clustering.setDistanceThreshold(0.03);
  };
  const Clustered apart = clusterAsPaper(cloud, setTighter);
  EXPECT_EQ(apart.patches.size(), 2U);
  EXPECT_EQ(apart.report.plane_distance, 0.03);
  const auto setNearer = [](PaperClustering& clustering) {
    clustering.setClusterTolerance(0.01);
  };
  EXPECT_EQ(clusterAsPaper(cloud, setNearer).patches.size(), 0U) << "nobody is so near";
}

/** The paper says nothing of creases: each vertex is a hypothesis. */
TEST(PaperMode, creasesAreHypothesesToo)
{
  Hypotheses cloud;
  addGrid(cloud, 20, 20, 0);
  const auto classes = std::make_shared<PointCloud<Label>>();
  classes->resize(cloud.size());
  for (Label& label : *classes)
    label.label = 2;
  const Clustered found = clusterAsPaper(cloud, [&](PaperClustering& clustering) {
    clustering.setVertexClasses(classes);
  });
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.report.hypotheses, 400U);
  EXPECT_EQ(found.patches[0].support, 400U);
}

TEST(NoiseDriven, creasesAreNoSeedsButMayJoin)
{
  const VotingMesh wall = makeWall(2, 2);
  const auto normals = std::make_shared<PointCloud<Normal>>();
  normals->resize(wall.cloud.size(), Normal(0, 0, 1));
  const auto classes = std::make_shared<PointCloud<Label>>();
  classes->resize(wall.cloud.size());
  for (std::size_t i = 0; i < classes->size(); ++i)
    (*classes)[i].label = i == 7 ? 1 : i % 2 + 2;
  const auto setClasses = [&](Clustering& clustering) {
    clustering.setInputNormals(normals);
    clustering.setVertexClasses(classes);
  };
  const Clustered found = clusterOn(wall, setClasses);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.report.hypotheses, 1U);
  EXPECT_EQ(found.patches[0].support, wall.cloud.size());
  (*classes)[7].label = 2;
  const Clustered none = clusterOn(wall, setClasses);
  EXPECT_EQ(none.patches.size(), 0U);
  EXPECT_FALSE(none.report.remarks.empty());
}

TEST(PaperMode, withoutMeshThereAreNoOutlines)
{
  Hypotheses cloud;
  addGrid(cloud, 20, 20, 0);
  const Clustered found = clusterAsPaper(cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_TRUE(found.patches[0].polygons.empty());
  EXPECT_FALSE(found.report.remarks.empty());
}

} // namespace
} // namespace pcl::acmap::test
