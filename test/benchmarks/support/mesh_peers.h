#pragma once

#include "clouds.h"
#include "mesh_checker.h"
#include "simulated_clouds.h"

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief PCL's GreedyProjectionTriangulation with the normals that it needs, on one
 * thread.
 *
 * Normals are from 16 neighbours and point towards the origin; mu is 2.5, with at most
 * 100 neighbours; the search radius is ten spacings, although mu limits it to less
 * nearly everywhere.
 * \param[in] cloud finite points only
 * \param[in] spacing metres between neighbouring points */
test::Triangles
greedyProjection(const test::Cloud& cloud, double spacing);

/** \brief Result of PCL's NormalEstimation for all points of a cloud. Scene frame. */
struct PeerNormals {
  std::string name;
  test::Points places;
  test::Points normals;
  double seconds = 0; ///< CPU time of one thread, including the search tree
};

/** \brief By the 16 nearest points, and by those within 10 cm. */
std::vector<PeerNormals>
peerNormals(const SimulatedCloud& cloud);

} // namespace pcl::acmap::bench
