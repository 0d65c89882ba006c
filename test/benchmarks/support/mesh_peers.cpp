#include "mesh_peers.h"

#include "bench.h"
#include "simulated_clouds.h"

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

std::vector<PeerNormals>
peerNormals(const SimulatedCloud& cloud)
{
  std::vector<PeerNormals> peers;
  for (const bool by_radius : {false, true}) {
    PeerNormals& peer = peers.emplace_back();
    peer.name = "PCL NormalEstimation, ";
    peer.name += by_radius ? "radius 10 cm" : "k = 16";
    PointCloud<Normal> estimated;
    peer.seconds = measureThread([&] {
      NormalEstimation<PointXYZ, Normal> estimation;
      estimation.setInputCloud(plainPoints(cloud));
      estimation.setSearchMethod(std::make_shared<search::KdTree<PointXYZ>>());
      if (by_radius)
        estimation.setRadiusSearch(0.1);
      else
        estimation.setKSearch(16);
      estimation.compute(estimated);
    });
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      peer.places.push_back(cloud.T_scene_cloud *
                            cloud.merged.points[i].cast<double>());
      peer.normals.push_back(cloud.T_scene_cloud.linear() *
                             estimated[i].getNormalVector3fMap().cast<double>());
    }
  }
  return peers;
}

} // namespace pcl::acmap::bench
