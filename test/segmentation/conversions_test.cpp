#include "clustering_runs.h"

#include <pcl/common/centroid.h>
#include <pcl/segmentation/plane_conversions.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** A wall with a window in general position, and its point cloud. */
VotingMesh
makeTiltedWall()
{
  const VotingMesh wall = without(makeWall(4, 2.5), [](const PointXYZ& point) {
    return point.x > 0.5F && point.x < 1.3F && std::abs(point.y) < 0.5F;
  });
  VotingMesh tilted = wall;
  tilted.cloud = moved(wall.cloud, makeRandomMotion(3, 2));
  return tilted;
}

TEST(PlaneConversions, modelCoefficients)
{
  PlanePatch patch;
  patch.coefficients = {0.6, 0, -0.8, 1.25};
  ModelCoefficients model;
  model.header.frame_id = "map";
  model.values.resize(7, 3.0F);
  toModelCoefficients(patch, model);
  EXPECT_EQ(model.values, (std::vector<float>{0.6F, 0, -0.8F, 1.25F}));
  EXPECT_EQ(model.header.frame_id, "map");
}

TEST(PlaneConversions, planarRegionHasWhatPclMeans)
{
  const VotingMesh wall = withNoise(makeTiltedWall(), {1, 0, 0}, 0.0005);
  const Clustered found = clusterOn(wall);
  ASSERT_EQ(found.patches.size(), 1U);
  const PlanePatch& patch = found.patches[0];
  PlanarRegion<PointNormal> region;
  toPlanarRegion(patch, region);

  EXPECT_EQ(region.getCount(), wall.cloud.size());
  EXPECT_LT((region.getCoefficients() - patch.coefficients.cast<float>()).norm(),
            1e-6F);
  ASSERT_EQ(region.getContour().size(), patch.polygons[0].outer.size());
  for (std::size_t i = 0; i < region.getContour().size(); ++i)
    EXPECT_EQ(region.getContour()[i].getVector3fMap(), patch.polygons[0].outer[i]);

  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
  Eigen::Vector4f centroid = Eigen::Vector4f::Zero();
  computeMeanAndCovarianceMatrix(wall.cloud, covariance, centroid);
  EXPECT_LT((region.getCentroid() - centroid.head<3>()).norm(), 0.02F);
  EXPECT_LT((region.getCovariance() - covariance).norm(), 0.05F * covariance.norm());
  EXPECT_GT(region.getCurvature(), 0);
  EXPECT_LT(region.getCurvature(), 1e-6F);
}

TEST(PlaneConversions, spreadOfARectangleIsKnown)
{
  PlanePatch patch;
  patch.coefficients = {0, 0, 1, 0};
  patch.rms = 0.5;
  patch.polygons.push_back({{{0, 0, 0}, {6, 0, 0}, {6, 2, 0}, {0, 2, 0}}, {}});
  const Eigen::Matrix3d wanted = Eigen::Vector3d(3, 1.0 / 3, 0.25).asDiagonal();
  EXPECT_LT((spreadOf(patch) - wanted).norm(), 1e-9);
  patch.center = {-100, 7, 0};
  EXPECT_LT((spreadOf(patch) - wanted).norm(), 1e-6) << "wherever the centre is";
}

TEST(PlaneConversions, contourIsTheLargestRim)
{
  PlanePatch patch;
  patch.coefficients = {0, 0, 1, 0};
  patch.polygons.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}});
  patch.polygons.push_back({{{5, 0, 0}, {7, 0, 0}, {5, 2, 0}}, {}});
  PlanarRegion<PointXYZ> region;
  toPlanarRegion(patch, region);
  ASSERT_EQ(region.getContour().size(), 3U);
  EXPECT_EQ(region.getContour()[1].x, 7);
}

TEST(PlaneConversions, outlinesHaveAllPolygonsAndTheirHoles)
{
  PlanePatch patch;
  const std::vector<Eigen::Vector3f> hole{{1, 1, 0}, {1, 2, 0}, {2, 1, 0}};
  patch.polygons.push_back({{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {hole, {}}});
  patch.polygons.push_back({{{5, 0, 3}, {7, 0, 3}, {7, 2, 3}, {5, 2, 3}}, {}});
  std::vector<PlaneOutline<PointNormal>> outlines(5);
  toOutlines(patch, outlines);
  ASSERT_EQ(outlines.size(), 2U);
  EXPECT_EQ(outlines[0].outer.width, 3U);
  EXPECT_EQ(outlines[0].outer[1].getVector3fMap(), Eigen::Vector3f(9, 0, 0));
  ASSERT_EQ(outlines[0].holes.size(), 2U);
  ASSERT_EQ(outlines[0].holes[0].size(), 3U);
  EXPECT_EQ(outlines[0].holes[0][1].getVector3fMap(), Eigen::Vector3f(1, 2, 0));
  EXPECT_EQ(outlines[0].holes[0][1].curvature, 0);
  EXPECT_TRUE(outlines[0].holes[1].empty());
  EXPECT_EQ(outlines[1].outer.size(), 4U);
  EXPECT_TRUE(outlines[1].holes.empty());
  toOutlines(PlanePatch(), outlines);
  EXPECT_TRUE(outlines.empty());
}

TEST(PlaneConversions, labelsAreIndicesOfEachPlane)
{
  const PointLabels labels{1, -1, 0, 1, -1};
  PCLHeader header;
  header.frame_id = "map";
  const std::vector<PointIndices> planes = toPointIndices(labels, 3, header);
  ASSERT_EQ(planes.size(), 3U);
  EXPECT_EQ(planes[0].indices, Indices{2});
  EXPECT_EQ(planes[1].indices, (Indices{0, 3}));
  EXPECT_TRUE(planes[2].indices.empty());
  EXPECT_EQ(planes[2].header.frame_id, "map");
  EXPECT_EQ(toPointIndices(labels, 2)[1].header.frame_id, "");
  EXPECT_THROW(toPointIndices(labels, 1), BadArgumentException);
  EXPECT_EQ(toVector(labels), (std::vector<int>{1, -1, 0, 1, -1}));
}

TEST(PlaneConversions, patchWithoutPolygonsHasNoContour)
{
  PlanePatch patch;
  patch.coefficients = {1, 0, 0, -2};
  patch.center = {2, 0, 0};
  patch.rms = 0.01;
  PlanarRegion<PointXYZ> region;
  toPlanarRegion(patch, region);
  EXPECT_TRUE(region.getContour().empty());
  EXPECT_EQ(region.getCentroid(), Eigen::Vector3f(2, 0, 0));
  EXPECT_NEAR(region.getCovariance()(0, 0), 1e-4, 1e-9);
  toPlanarRegion(PlanePatch(), region);
  EXPECT_EQ(region.getCount(), 0U);
  EXPECT_EQ(region.getCurvature(), 0);
}

} // namespace
} // namespace pcl::acmap::test
