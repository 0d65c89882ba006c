#pragma once

#include "voting_meshes.h"

#include <pcl/features/normal_vector_voting.h>

#include <cmath>
#include <functional>

namespace pcl::acmap::test {

constexpr double degree = M_PI / 180; // radians

/** \brief Complete result of a run. */
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

/** \brief Runs an object and collects all outputs, including curvatures if enabled. */
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

/** \param[in] set changes default settings */
Voted
voteOn(
    const VotingMesh& mesh, const std::function<void(Voting&)>& set = [](Voting&) {});

/** \brief Direction of the crease at each vertex: e3 of the kernel. Default
 * settings. */
std::vector<Eigen::Vector3f>
creaseDirections(const VotingMesh& mesh);

/** \brief Maximum difference of the unit normals of two runs; infinite if a normal is
 * known in one run only. */
double
largestDifference(const Voted& a, const Voted& b);

} // namespace pcl::acmap::test
