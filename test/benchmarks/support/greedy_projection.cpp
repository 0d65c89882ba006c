#include "greedy_projection.h"

#include <pcl/common/io.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/gp3.h>

namespace pcl::acmap::bench {

test::Triangles
greedyProjection(const test::Cloud& cloud, double spacing)
{
  const auto input = cloud.makeShared();
  PointCloud<Normal> normals;
  NormalEstimation<PointXYZ, Normal> estimation;
  estimation.setInputCloud(input);
  estimation.setSearchMethod(std::make_shared<search::KdTree<PointXYZ>>());
  estimation.setKSearch(16);
  estimation.compute(normals);

  const auto oriented = std::make_shared<PointCloud<PointNormal>>();
  concatenateFields(cloud, normals, *oriented);
  GreedyProjectionTriangulation<PointNormal> triangulation;
  triangulation.setSearchRadius(10 * spacing);
  triangulation.setMu(2.5);
  triangulation.setMaximumNearestNeighbors(100);
  triangulation.setMaximumSurfaceAngle(M_PI / 4);
  triangulation.setMinimumAngle(M_PI / 18);
  triangulation.setMaximumAngle(2 * M_PI / 3);
  triangulation.setNormalConsistency(false);
  triangulation.setConsistentVertexOrdering(true);
  triangulation.setInputCloud(oriented);
  triangulation.setSearchMethod(std::make_shared<search::KdTree<PointNormal>>());
  std::vector<Vertices> polygons;
  triangulation.reconstruct(polygons);
  return test::toTriangles(polygons);
}

} // namespace pcl::acmap::bench
