#include "pcl_planes.h"

#include "region_planes.h"

#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

#include <cmath>
#include <limits>
#include <memory>

namespace pcl::acmap::bench {
namespace {

using Tree = search::KdTree<PointXYZ>;

/** Excludes points with too few neighbours, as RegionGrowing accepts NaN normals. */
void
takeAwayInvalid(PointCloud<Normal>& normals)
{
  for (Normal& normal : normals)
    if (!normal.getNormalVector3fMap().allFinite()) {
      normal.getNormalVector3fMap().setZero();
      normal.curvature = 1;
    }
}

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
  takeAwayInvalid(*normals);
  return normals;
}

std::vector<Indices>
regionsByPcl(const PlaneInput& input)
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

} // namespace

FoundPlanes
pclRegionPlanes(const PlaneInput& input)
{
  return timedPlanes([&] { return planesOfRegions(input, regionsByPcl(input)); });
}

} // namespace pcl::acmap::bench
