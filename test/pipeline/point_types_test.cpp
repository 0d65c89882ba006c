#include "depth_room.h"

#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/core/random.h>
#include <pcl/features/normal_vector_voting.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/map_entropy.h>
#include <pcl/mapping/map_levelling.h>
#include <pcl/mapping/map_verdict.h>
#include <pcl/mapping/plane_adjustment.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>
#include <pcl/segmentation/depth_plane_segmentation.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>
#include <pcl/surface/dewall_triangulation.h>
#include <pcl/texture/plane_texturing.h>

#include <boost/preprocessor/seq/enum.hpp>
#include <gtest/gtest.h>

#include <initializer_list>

namespace pcl::acmap::test {
namespace {

template <typename PointT>
class AllPointTypes : public testing::Test {};

/** Those of the list for which classes are compiled, which PCL keeps. */
using Types = testing::Types<BOOST_PP_SEQ_ENUM(ACMAP_ALL_POINT_TYPES)>;

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

/** An image of a wall, which no class needs colours or normals for. */
template <typename PointT>
typename PointCloud<PointT>::Ptr
imageOfAWall()
{
  typename PointCloud<PointT>::Ptr cloud(new PointCloud<PointT>(40, 30));
  for (unsigned column = 0; column < 40; ++column)
    for (unsigned row = 0; row < 30; ++row) {
      PointT& point = cloud->at(column, row);
      point.x = 0.05F * static_cast<float>(column) - 1;
      point.y = 0.05F * static_cast<float>(row) - 0.75F;
      point.z = 2;
    }
  return cloud;
}

TYPED_TEST(AllPointTypes, areTakenByTheClassesOfMaps)
{
  const auto cloud = imageOfAWall<TypeParam>();
  MapEntropy<TypeParam> entropy;
  entropy.addPointCloud(cloud, PlanarPose());
  entropy.compute();
  EXPECT_FALSE(entropy.getReport().seconds.empty());
  const Eigen::Isometry3d identity = Eigen::Isometry3d::Identity();
  MapLevelling<TypeParam> levelling;
  levelling.addPointCloud(cloud, identity);
  levelling.compute();
  EXPECT_FALSE(levelling.getReport().seconds.empty());
  MapVerdict<TypeParam> verdict;
  verdict.addPointCloud(cloud, identity);
  verdict.compute();
  EXPECT_FALSE(verdict.getReport().seconds.empty());
  EntropyRectification<TypeParam> rectification;
  PlaneAdjustment<TypeParam> adjustment;
  for (Filter<TypeParam>* filter :
       std::initializer_list<Filter<TypeParam>*>{&rectification, &adjustment}) {
    PointCloud<TypeParam> map;
    filter->setInputCloud(cloud);
    filter->filter(map);
    EXPECT_EQ(map.size(), cloud->size());
  }
}

TYPED_TEST(AllPointTypes, areTakenByTheClassesOfImagesAndTexture)
{
  const typename PointCloud<TypeParam>::Ptr cloud(
      new PointCloud<TypeParam>(DepthRoom::width, DepthRoom::height));
  const DepthRoom room({});
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*cloud)[i].getVector3fMap() = room.points[i];
  DepthPlaneSegmentation<TypeParam> segmentation;
  segmentation.setInputCloud(cloud);
  std::vector<PlanePatch> planes;
  segmentation.segment(planes);
  ASSERT_EQ(planes.size(), 5U);
  DepthRefinement<TypeParam> refinement;
  refinement.setInputCloud(cloud);
  PointCloud<TypeParam> refined;
  refinement.filter(refined);
  EXPECT_EQ(refined.size(), cloud->size());
  PlaneTexturing<TypeParam> texturing;
  texturing.setPlanes(planes);
  texturing.addObservation(cloud, Eigen::Isometry3d::Identity());
  CompactMap map;
  texturing.texture(map);
  EXPECT_FALSE(texturing.getReport().seconds.empty());
  CylinderHypothesisClustering<TypeParam> clustering;
  clustering.setInputCloud(imageOfAWall<TypeParam>());
  std::vector<CylinderPatch> cylinders;
  clustering.segment(cylinders);
  EXPECT_FALSE(clustering.getReport().seconds.empty());
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
