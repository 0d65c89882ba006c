#pragma once

#include "simulated_clouds.h"

#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief Meshes representatives with the paper's rule on one thread: edges up to 2.5
 * voxels, faces oriented like the normals. */
TriangleMesh
meshOf(const Consolidation& consolidation, double voxel);

test::Points
placesInScene(const SimulatedCloud& cloud, const Consolidation& consolidation);

test::Points
normalsInScene(const SimulatedCloud& cloud, const Consolidation& consolidation);

} // namespace pcl::acmap::bench
