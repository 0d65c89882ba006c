#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/core/random.h>
#include <pcl/features/normal_vector_voting.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>
#include <pcl/surface/dewall_triangulation.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

template <typename PointT>
class AllPointTypes : public testing::Test {};

#ifdef ACMAP_FEW_POINT_TYPES
using Types = testing::Types<PointXYZ, PointXYZRGB, PointNormal>;
#else
using Types = testing::Types<PointXYZ,
                             PointXYZI,
                             PointXYZL,
                             PointXYZRGB,
                             PointXYZRGBA,
                             PointNormal,
                             PointXYZRGBNormal,
                             PointXYZINormal,
                             PointXYZLNormal,
                             PointWithRange,
                             PointWithScale,
                             PointSurfel>;
#endif

TYPED_TEST_SUITE(AllPointTypes, Types);

/** A noisy floor of two metres. */
template <typename PointT>
typename PointCloud<PointT>::Ptr
floorOf()
{
  Random random(3);
  typename PointCloud<PointT>::Ptr cloud(new PointCloud<PointT>);
  for (int i = 0; i < 20000; ++i) {
    PointT point{};
    point.x = static_cast<float>(random.uniform(0, 2));
    point.y = static_cast<float>(1 + 0.01 * random.normal());
    point.z = static_cast<float>(random.uniform(0, 2));
    cloud->push_back(point);
  }
  return cloud;
}

/** A program for a class of PCL's surface module, but for the name of the class. */
TYPED_TEST(AllPointTypes, areMeshedAsByPclsClasses)
{
  typename PointCloud<TypeParam>::Ptr cloud(new PointCloud<TypeParam>);
  VoxelConsolidation<TypeParam> filter;
  filter.setInputCloud(floorOf<TypeParam>());
  filter.filter(*cloud);

  typename search::KdTree<TypeParam>::Ptr tree(new search::KdTree<TypeParam>);
  tree->setInputCloud(cloud);
  DeWallTriangulation<TypeParam> mesher;
  mesher.setInputCloud(cloud);
  mesher.setSearchMethod(tree);
  PolygonMesh mesh;
  mesher.reconstruct(mesh);
  EXPECT_GT(mesh.polygons.size(), cloud->size());
  EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, cloud->size());

  NormalVectorVoting<TypeParam> voting;
  voting.setInputCloud(cloud);
  voting.setTriangles(mesh.polygons);
  const PointCloud<Normal>::Ptr normals(new PointCloud<Normal>);
  voting.compute(*normals);
  PlaneHypothesisClustering<TypeParam> clustering;
  clustering.setInputCloud(cloud);
  clustering.setInputNormals(normals);
  clustering.setTriangles(mesh.polygons);
  clustering.setNoiseDriven(true);
  std::vector<PlanePatch> planes;
  clustering.segment(planes);
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_NEAR(std::abs(planes[0].coefficients[1]), 1, 1e-3);
}

} // namespace
} // namespace pcl::acmap::test
