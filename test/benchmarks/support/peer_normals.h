#pragma once

#include "simulated_clouds.h"

#include "mesh_checker.h"

#include <string>

namespace pcl::acmap::bench {

/** \brief Result of PCL's NormalEstimation for all points of a cloud. Scene frame. */
struct PeerNormals {
  std::string name;
  test::Points places;
  test::Points normals;
  double seconds = 0; ///< CPU time of one thread, including the search tree
};

PeerNormals
normalsOfNearest(const SimulatedCloud& cloud, int neighbours);

/** \param[in] radius metres */
PeerNormals
normalsWithin(const SimulatedCloud& cloud, double radius);

} // namespace pcl::acmap::bench
