#pragma once

#include "clouds.h"
#include "mesh_checker.h"

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

} // namespace pcl::acmap::bench
