#include "clustering_runs.h"

#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <gtest/gtest.h>

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

/** Adds points on z = 0, 10 cm apart, starting at a corner. */
void
addGrid(Hypotheses& cloud,
        int columns,
        int rows,
        double x,
        const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ())
{
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      cloud.push_back(hypothesis({x + 0.1 * column, 0.1 * row, 0}, normal));
}

std::size_t
planesOf(const Hypotheses& cloud)
{
  return clusterAsPaper(cloud).patches.size();
}

TEST(PaperMode, thresholdsAreThePapers)
{
  const PaperClustering clustering;
  EXPECT_FALSE(clustering.getNoiseDriven());
  EXPECT_DOUBLE_EQ(clustering.getClusterTolerance(), 0.8);
  EXPECT_DOUBLE_EQ(clustering.getSmoothnessThreshold(), M_PI / 8);
  EXPECT_DOUBLE_EQ(clustering.getDistanceThreshold(), 0.25);
  EXPECT_EQ(clustering.getMinClusterSize(), 50U);
  const PlaneClusteringSettings settings;
  EXPECT_FALSE(settings.noise_driven);
  EXPECT_EQ(settings.member_distance, clustering.getClusterTolerance());
  EXPECT_NEAR(settings.normal_angle, clustering.getSmoothnessThreshold(), 1e-8);
  EXPECT_EQ(settings.plane_distance, clustering.getDistanceThreshold());
  EXPECT_EQ(settings.min_support, clustering.getMinClusterSize());
}

TEST(PaperMode, moreThanFiftySupporters)
{
  Hypotheses cloud;
  addGrid(cloud, 10, 5, 0);
  const Clustered refused = clusterAsPaper(cloud);
  EXPECT_EQ(refused.patches.size(), 0U);
  EXPECT_EQ(refused.report.small_regions, 1U);
  ASSERT_FALSE(refused.report.remarks.empty());
  EXPECT_NE(refused.report.remarks.back().find("no planes"), std::string::npos);
  cloud.push_back(hypothesis({0, 0.5, 0}, {0, 0, 1}));
  const Clustered found = clusterAsPaper(cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, 51U);
  EXPECT_EQ(
      clusterAsPaper(
          cloud, [](PaperClustering& clustering) { clustering.setMinClusterSize(51); })
          .patches.size(),
      0U);
}

/** Points must be near any supporter, not near the seed: the wall of a corridor is one
 * plane. */
TEST(PaperMode, distanceIsToSomeSupporter)
{
  Hypotheses cloud;
  addGrid(cloud, 100, 3, 0);
  const Clustered found = clusterAsPaper(cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, 300U);
  for (const double gap : {0.79, 0.81}) {
    Hypotheses groups; // of forty points each
    addGrid(groups, 8, 5, 0);
    addGrid(groups, 8, 5, 0.7 + gap);
    EXPECT_EQ(planesOf(groups), gap < 0.8 ? 1U : 0U) << gap;
  }
}

TEST(PaperMode, normalsDifferByLessThanAnEighthOfPi)
{
  for (const double angle : {22.0, 23.0, 90.0, 158.0, 180.0}) {
    Hypotheses groups;
    addGrid(groups, 8, 5, 0);
    addGrid(groups, 8, 5, 0.8, {std::sin(angle * degree), 0, std::cos(angle * degree)});
    EXPECT_EQ(planesOf(groups), angle < 22.5 ? 1U : 0U) << angle;
  }
}

TEST(PaperMode, distanceToThePlaneIsLessThanAQuarterMetre)
{
  for (const double height : {0.24, 0.26, -0.24, -0.26}) {
    Hypotheses cloud;
    addGrid(cloud, 30, 30, 0);
    cloud.push_back(hypothesis({1.45, 1.45, height}, {0, 0, 1}));
    const Clustered found = clusterAsPaper(cloud);
    ASSERT_EQ(found.patches.size(), 1U);
    EXPECT_EQ(found.patches[0].support, std::abs(height) < 0.25 ? 901U : 900U)
        << height;
  }
}

/** Points within W_t with other normals are not added, neither at the border nor far
 * from it. */
TEST(PaperMode, nearnessAloneIsNoSupport)
{
  Hypotheses cloud;
  addGrid(cloud, 30, 30, 0);
  for (int k = 0; k < 20; ++k) {
    cloud.push_back(hypothesis({0.5 + 0.1 * k, 1.5, 0.1}, {1, 0, 0}));
    cloud.push_back(hypothesis({0.5 + 0.1 * k, 2.5, 0.2}, {0, 0, -1}));
  }
  const Clustered found = clusterAsPaper(cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, 900U);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_EQ(found.labels[i], i < 900 ? 0 : -1) << i;
}

/** Steps of 20 cm, each within W_t of the plane of all previous ones: the plane tilts
 * towards the slope of the stairs. */
TEST(PaperMode, planeFollowsItsSupporters)
{
  Hypotheses cloud;
  for (int step = 0; step < 6; ++step)
    for (int k = 0; k < 60; ++k)
      cloud.push_back(hypothesis(
          {0.5 * step + 0.05 * (k % 10), 0.2 * (k / 10), 0.1 * step}, {-0.2, 0, 1}));
  const Clustered found = clusterAsPaper(cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].support, cloud.size());
  EXPECT_LT(angleFrom(found.patches[0], {-0.2, 0, 1}), 2 * degree);
}

TEST(PaperMode, thresholdsCanBeSet)
{
  Hypotheses cloud; // two boards, 10 cm apart in depth
  addGrid(cloud, 20, 20, 0);
  for (int k = 0; k < 400; ++k)
    cloud.push_back(hypothesis({2 + 0.1 * (k % 20), 0.1 * (k / 20), -0.1}, {0, 0, 1}));
  EXPECT_EQ(planesOf(cloud), 1U) << "the paper's W_t swallows it";
  const auto setTighter = [](PaperClustering& clustering) {
    clustering.setDistanceThreshold(0.03);
  };
  const Clustered apart = clusterAsPaper(cloud, setTighter);
  EXPECT_EQ(apart.patches.size(), 2U);
  EXPECT_EQ(apart.report.plane_distance, 0.03);
  const auto setFarther = [](PaperClustering& clustering) {
    clustering.setClusterTolerance(0.05);
  };
  EXPECT_EQ(clusterAsPaper(cloud, setFarther).patches.size(), 0U)
      << "nobody is so near";
}

TEST(PaperMode, creasesAreNoSeedsButMayJoin)
{
  Hypotheses cloud;
  addGrid(cloud, 20, 20, 0);
  const auto classes = std::make_shared<PointCloud<Label>>();
  classes->resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    (*classes)[i].label = i == 7 ? 1 : i % 2 + 2;
  const auto setClasses = [&](PaperClustering& clustering) {
    clustering.setVertexClasses(classes);
  };
  const Clustered found = clusterAsPaper(cloud, setClasses);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.report.hypotheses, 1U);
  EXPECT_EQ(found.patches[0].support, 400U);
  (*classes)[7].label = 2;
  const Clustered none = clusterAsPaper(cloud, setClasses);
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
