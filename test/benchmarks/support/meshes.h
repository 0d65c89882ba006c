#pragma once

#include "mesh_checker.h"
#include "simulated_clouds.h"

#include <pcl/features/impl/voting_kernel.h>
#include <pcl/surface/impl/dewall_kernel.h>

#include <string>

namespace pcl::acmap::bench {

struct RawMesh {
  TriangleMesh mesh;
  DeWallReport report;
};

/** \brief Meshes points without prior knowledge: automatic edge length, no normals or
 * sensors. */
RawMesh
meshRaw(const PointView& points, DeWallRule rule, unsigned threads = 1);

/** \brief "DeWall paper" or "DeWall dense". */
std::string
ruleName(DeWallRule rule);

/** \brief Meshes representatives with the paper's rule on one thread: edges up to 2.5
 * voxels, faces oriented like the normals. */
TriangleMesh
meshOf(const Consolidation& consolidation, double voxel);

test::Points
placesInScene(const SimulatedCloud& cloud, const Consolidation& consolidation);

test::Points
normalsInScene(const SimulatedCloud& cloud, const Consolidation& consolidation);

/** \brief CPU seconds of the steps from points to normals, on one thread. */
struct VotingSeconds {
  double consolidation = 0;
  double mesh = 0;
  double votes = 0;
};

/** \brief The representatives of a cloud, their mesh and its votes. */
struct VotedMesh {
  Consolidation consolidation;
  ConsolidationReport report;
  TriangleMesh mesh;
  VotedNormals votes;
  VotingSeconds seconds;

  PointView
  vertices() const;
};

/** \brief All three steps on one thread, automatic voxel and radius. */
VotedMesh
meshAndVote(const SimulatedCloud& cloud, const VotingSettings& settings = {});

/** \brief Votes again on the same mesh. */
VotedNormals
voteAgain(const VotedMesh& voted, VotingSettings settings);

test::Points
votedNormalsInScene(const SimulatedCloud& cloud, const VotedMesh& voted);

/** \brief For each vertex, is it a crease or a corner? */
std::vector<bool>
creasesOf(const VotedNormals& votes);

} // namespace pcl::acmap::bench
