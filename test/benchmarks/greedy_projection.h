#pragma once

#include "clouds.h"
#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief PCL's GreedyProjectionTriangulation with the normals it needs, on one thread.
 *
 * Normals from 16 neighbours towards the origin; 2.5 times the nearest neighbour, at most
 * 100 neighbours; a search radius of ten spacings, which its own limit undercuts nearly
 * everywhere.
 * \param[in] cloud finite points only
 * \param[in] spacing metres between neighbouring points */
test::Triangles
greedyProjection(const test::Cloud& cloud, double spacing);

} // namespace pcl::acmap::bench
