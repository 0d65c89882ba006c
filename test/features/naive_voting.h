#pragma once

#include "voting_meshes.h"

#include <pcl/features/voting_types.h>

namespace pcl::acmap::test {

/** \brief What Page's equations say of a vertex, in doubles. */
struct NaiveVote {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  Eigen::Vector3d eigenvalues = Eigen::Vector3d::Zero(); ///< rising, their sum is 1
  VertexClass vertex_class = VertexClass::Unknown;
};

struct NaiveSettings {
  double radius = 1;
  double nearest = 0; ///< metres; nearer triangles do not vote
  double crease_weight = 12;
  double corner_weight = 0.3;
};

/** \brief Lengths of the shortest paths along edges from a vertex to all others. */
std::vector<double>
pathLengths(const VotingMesh& mesh, std::size_t vertex);

/** \brief Page et al., Eq. 6 to 10, as they stand, with the mean of the corners' path
 * lengths for the way to a triangle: each vertex asks each triangle. */
NaiveVote
voteNaively(const VotingMesh& mesh, std::size_t vertex, const NaiveSettings& settings);

} // namespace pcl::acmap::test
