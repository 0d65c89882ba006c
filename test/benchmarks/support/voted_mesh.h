#pragma once

#include "simulated_clouds.h"

#include "mesh_checker.h"

#include <pcl/features/impl/voting_kernel.h>

namespace pcl::acmap::bench {

/** \brief CPU seconds of the steps from points to normals, on one thread. */
struct VotingSeconds {
  double consolidation = 0;
  double mesh = 0;
  double votes = 0;

  double
  sum() const
  {
    return consolidation + mesh + votes;
  }
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
