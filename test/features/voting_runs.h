#pragma once

#include "voting_meshes.h"

#include <pcl/features/normal_vector_voting.h>

#include <cmath>
#include <functional>

namespace pcl::acmap::test {

constexpr double degree = M_PI / 180; // radians

/** \brief All that a run gives. */
struct Voted {
  PointCloud<Normal> normals;
  PointCloud<Label> classes;
  PointCloud<PrincipalCurvatures> curvatures;
  VotingReport report;

  Eigen::Vector3f
  normal(std::size_t vertex) const
  {
    return normals[vertex].getNormalVector3fMap();
  }

  VertexClass
  classOf(std::size_t vertex) const
  {
    return static_cast<VertexClass>(classes[vertex].label);
  }
};

using Voting = NormalVectorVoting<PointXYZ>;

/** \brief Asks an object for all that it gives, curvatures where it was told to. */
template <typename PointT>
Voted
runVoting(NormalVectorVoting<PointT>& voting)
{
  Voted voted;
  voting.compute(voted.normals);
  voting.getVertexClasses(voted.classes);
  voting.getPrincipalCurvatures(voted.curvatures);
  voted.report = voting.getReport();
  return voted;
}

/** \param[in] set what is not to stay at its default */
Voted
voteOn(
    const VotingMesh& mesh, const std::function<void(Voting&)>& set = [](Voting&) {});

/** \brief Along the crease at each vertex: the kernel's e3. Default settings. */
std::vector<Eigen::Vector3f>
creaseDirections(const VotingMesh& mesh);

/** \brief Largest difference of two unit normals, where both are told; infinite where only
 * one is. */
double
largestDifference(const Voted& a, const Voted& b);

} // namespace pcl::acmap::test
