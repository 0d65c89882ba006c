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
  std::size_t votes = 0;
};

struct NaiveVotingSettings {
  double radius = 1;
  double crease_weight = 2, corner_weight = 2;
  double nearest = 0; ///< metres; closer triangles do not vote; 0 as in Page et al.
  std::size_t min_votes = 1; ///< as in Page et al.
  bool is_slanted = false;   ///< with our factor 1 - (n u)^2
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
