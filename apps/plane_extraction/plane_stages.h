#pragma once

#include "consolidation_stage.h"

#include <pcl/core/triangle_mesh.h>
#include <pcl/features/voting_kernel.h>
#include <pcl/segmentation/plane_clustering_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief A mesh whose vertices are hypotheses of planes, with what it votes. */
struct HypothesisMesh {
  PointCloudFile vertices;
  TriangleMesh mesh;
  VotedNormals votes;
  double spacing = 0; ///< metres, between neighbouring vertices
};

/** \brief Makes the mesh of all points, as a step of the tool.
 * \throws MemoryRefused when this machine has too little */
HypothesisMesh
meshAsItIs(Tool& tool, const PointCloudFile& file);

/** \brief Makes the mesh of consolidated points, as a step of the tool.
 * \throws MemoryRefused when this machine has too little */
HypothesisMesh
meshConsolidated(Tool& tool, ConsolidatedCloud cloud, double voxel_size);

/** \brief Votes for the normals of a mesh, as a step of the tool.
 * \param[in] sensors who saw the vertices, and where the normals look; unknown: they look
 * where the faces do, as those of consolidated points are turned to the sensors already */
void
voteOnMesh(Tool& tool, HypothesisMesh& mesh, const SensorView& sensors);

/** \brief About how long the paper's growth of planes takes, seconds: it looks at each pair
 * of points within W_d several times.
 * \param[in] member_distance W_d, metres */
double
secondsOfPaperGrowth(const PointView& points, double member_distance);

/** \brief Finds the planes, as a step of the tool; warns before where that takes long.
 * \param[in] source the points that the vertices stand for; may be empty */
PlaneClusters
findPlanes(Tool& tool,
           const HypothesisMesh& mesh,
           const PlaneSource& source,
           PlaneClusteringSettings settings);

} // namespace pcl::acmap
