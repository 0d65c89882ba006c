#pragma once

#include "voting_meshes.h"

#include <pcl/features/voting_types.h>

namespace pcl::acmap::test {

/** \brief Result of Page's equations for a vertex, in double precision. */
struct NaiveVote {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  Eigen::Vector3d eigenvalues = Eigen::Vector3d::Zero(); ///< ascending, with sum 1
  VertexClass vertex_class = VertexClass::Unknown;
};

struct NaiveVotingSettings {
  double radius = 1;
  double nearest = 0; ///< metres; closer triangles do not vote
  double crease_weight = 12;
  double corner_weight = 0.3;
};

/** \brief Lengths of the shortest paths along edges from a vertex to all others. */
std::vector<double>
pathLengths(const VotingMesh& mesh, std::size_t vertex);

/** \brief Direct implementation of Page et al., Eq. 6 to 10, with the mean of the
 * corners' path lengths as the distance of a triangle: each triangle votes for each
 * vertex. */
NaiveVote
voteNaively(const VotingMesh& mesh,
            std::size_t vertex,
            const NaiveVotingSettings& settings);

} // namespace pcl::acmap::test
