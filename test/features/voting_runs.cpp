#include "voting_runs.h"

#include <pcl/features/impl/voting_kernel.h>

#include <algorithm>
#include <limits>

namespace pcl::acmap::test {

Voted
voteOn(const VotingMesh& mesh, const std::function<void(Voting&)>& set)
{
  Voting voting;
  voting.setInputCloud(mesh.cloud.makeShared());
  voting.setTriangles(mesh.faces);
  set(voting);
  return runVoting(voting);
}

std::vector<Eigen::Vector3f>
creaseDirections(const VotingMesh& mesh)
{
  VotingReport report;
  const VotedNormals voted =
      voteNormals(PointView(&mesh.cloud.front().x, sizeof(PointXYZ), mesh.cloud.size()),
                  mesh.faces.triangles,
                  SensorView(),
                  VotingSettings(),
                  Progress(),
                  report);
  std::vector<Eigen::Vector3f> directions;
  for (const VotedNormal& one : voted.normals)
    directions.push_back(one.direction);
  return directions;
}

double
largestDifference(const Voted& a, const Voted& b)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (a.normals.size() != b.normals.size())
    return infinity;
  double largest = 0;
  for (std::size_t v = 0; v < a.normals.size(); ++v) {
    const bool is_known = a.normal(v).allFinite();
    if (is_known != b.normal(v).allFinite())
      return infinity;
    if (is_known)
      largest =
          std::max(largest, static_cast<double>((a.normal(v) - b.normal(v)).norm()));
  }
  return largest;
}

} // namespace pcl::acmap::test
