#include "voted_mesh.h"

#include "consolidated_mesh.h"
#include "timing.h"

namespace pcl::acmap::bench {

PointView
VotedMesh::vertices() const
{
  const LargeVector<Representative>& all = consolidation.representatives;
  return {all.empty() ? nullptr : all.front().point.data(),
          sizeof(Representative),
          all.size()};
}

VotedMesh
meshAndVote(const SimulatedCloud& cloud, const VotingSettings& settings)
{
  VotedMesh voted;
  voted.seconds.consolidation =
      measureThread([&] { voted.consolidation = consolidate(cloud, 0, voted.report); });
  voted.seconds.mesh = measureThread(
      [&] { voted.mesh = meshOf(voted.consolidation, voted.report.voxel_size); });
  voted.seconds.votes =
      measureThread([&] { voted.votes = voteAgain(voted, settings); });
  return voted;
}

VotedNormals
voteAgain(const VotedMesh& voted, VotingSettings settings)
{
  settings.threads = 1;
  VotingReport report;
  return voteNormals(voted.vertices(),
                     voted.mesh.triangles,
                     SensorView(), // the mesh is already oriented
                     settings,
                     Progress(),
                     report);
}

test::Points
votedNormalsInScene(const SimulatedCloud& cloud, const VotedMesh& voted)
{
  test::Points normals;
  for (const VotedNormal& one : voted.votes.normals)
    normals.push_back(cloud.T_scene_cloud.linear() * one.normal.cast<double>());
  return normals;
}

std::vector<bool>
creasesOf(const VotedNormals& votes)
{
  std::vector<bool> is_crease;
  for (const VotedNormal& one : votes.normals)
    is_crease.push_back(one.vertex_class == VertexClass::Crease ||
                        one.vertex_class == VertexClass::Corner);
  return is_crease;
}

} // namespace pcl::acmap::bench
