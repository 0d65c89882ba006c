#include "bench.h"
#include "plane_finders.h"

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <memory>
#include <numeric>

namespace pcl::acmap::bench {
namespace {

using Tree = search::KdTree<PointXYZ>;

PointCloud<Normal>::Ptr
estimateNormals(const PlaneInput& input, const Tree::Ptr& tree)
{
  // With smaller radii noise splits regions; this gives 10 cm for the corridor's views.
  constexpr double spacings = 8;
  NormalEstimation<PointXYZ, Normal> estimation;
  estimation.setInputCloud(input.points);
  estimation.setSearchMethod(tree);
  estimation.setRadiusSearch(spacings * input.spacing);
  const auto normals = std::make_shared<PointCloud<Normal>>();
  estimation.compute(*normals);
  // Points with too few neighbours are excluded: RegionGrowing accepts NaN normals.
  for (Normal& normal : *normals)
    if (!normal.getNormalVector3fMap().allFinite()) {
      normal.getNormalVector3fMap().setZero();
      normal.curvature = 1;
    }
  return normals;
}

} // namespace

std::vector<Indices>
pclRegions(const PlaneInput& input)
{
  constexpr unsigned neighbours = 30;
  constexpr float max_angle = 3 * static_cast<float>(M_PI) / 180;
  constexpr float max_curvature = 0.1f;
  const auto tree = std::make_shared<Tree>();
  RegionGrowing<PointXYZ, Normal> growing;
  growing.setInputCloud(input.points);
  growing.setInputNormals(estimateNormals(input, tree));
  growing.setSearchMethod(tree);
  growing.setNumberOfNeighbours(neighbours);
  growing.setSmoothnessThreshold(max_angle);
  growing.setCurvatureThreshold(max_curvature);
  growing.setMinClusterSize(static_cast<int>(input.leastSupport()));
  growing.setMaxClusterSize(std::numeric_limits<int>::max());
  std::vector<PointIndices> clusters;
  growing.extract(clusters);
  std::vector<Indices> regions;
  for (PointIndices& cluster : clusters)
    regions.push_back(std::move(cluster.indices));
  return regions;
}

std::vector<Indices>
sacRegions(const PlaneInput& input)
{
  SACSegmentation<PointXYZ> sac;
  sac.setModelType(SACMODEL_PLANE);
  sac.setMethodType(SAC_RANSAC);
  sac.setMaxIterations(
      1000); // PCL's 50 miss planes with less than a quarter of the points
  sac.setDistanceThreshold(input.tolerance);
  sac.setOptimizeCoefficients(true);
  sac.setInputCloud(input.points);
  std::vector<Indices> planes;
  const auto left = std::make_shared<Indices>(input.points->size());
  std::iota(left->begin(), left->end(), 0);
  std::vector<bool> is_taken(input.points->size());
  while (left->size() >= input.leastSupport()) {
    PointIndices inliers;
    ModelCoefficients coefficients;
    sac.setIndices(left);
    sac.segment(inliers, coefficients);
    if (inliers.indices.size() < input.leastSupport())
      break;
    for (const index_t i : inliers.indices)
      is_taken[static_cast<std::size_t>(i)] = true;
    const auto isGone = [&](index_t i) {
      return is_taken[static_cast<std::size_t>(i)];
    };
    left->erase(std::remove_if(left->begin(), left->end(), isGone), left->end());
    planes.push_back(std::move(inliers.indices));
  }
  return planes;
}

} // namespace pcl::acmap::bench
