#include "peer_normals.h"

#include "simulated_points.h"
#include "timing.h"

#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include <sstream>

namespace pcl::acmap::bench {
namespace {

using Estimation = NormalEstimation<PointXYZ, Normal>;

template <typename SetNeighbours>
PeerNormals
estimate(const SimulatedCloud& cloud, const SetNeighbours& setNeighbours)
{
  PeerNormals peer;
  PointCloud<Normal> estimated;
  peer.seconds = measureThread([&] {
    Estimation estimation;
    estimation.setInputCloud(plainPoints(cloud));
    estimation.setSearchMethod(std::make_shared<search::KdTree<PointXYZ>>());
    setNeighbours(estimation);
    estimation.compute(estimated);
  });
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    peer.places.push_back(cloud.T_scene_cloud * cloud.merged.points[i].cast<double>());
    peer.normals.push_back(cloud.T_scene_cloud.linear() *
                           estimated[i].getNormalVector3fMap().cast<double>());
  }
  return peer;
}

} // namespace

PeerNormals
normalsOfNearest(const SimulatedCloud& cloud, int neighbours)
{
  PeerNormals peer = estimate(cloud, [&](Estimation& e) { e.setKSearch(neighbours); });
  peer.name = "PCL NormalEstimation, k = " + std::to_string(neighbours);
  return peer;
}

PeerNormals
normalsWithin(const SimulatedCloud& cloud, double radius)
{
  PeerNormals peer = estimate(cloud, [&](Estimation& e) { e.setRadiusSearch(radius); });
  std::ostringstream name;
  name << "PCL NormalEstimation, radius " << 100 * radius << " cm";
  peer.name = name.str();
  return peer;
}

} // namespace pcl::acmap::bench
