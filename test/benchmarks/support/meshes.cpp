#include "meshes.h"

#include "bench.h"

#include <pcl/surface/impl/dewall_kernel.h>

namespace pcl::acmap::bench {

RawMesh
meshRaw(const PointView& points, DeWallRule rule, unsigned threads)
{
  DeWallSettings settings;
  settings.rule = rule;
  DeWallInput input;
  input.points = points;
  input.threads = threads;
  RawMesh result;
  result.mesh = triangulateDeWall(input, settings, Progress(), result.report);
  return result;
}

std::string
ruleName(DeWallRule rule)
{
  return rule == DeWallRule::Guarded ? "DeWall paper" : "DeWall dense";
}

TriangleMesh
meshOf(const Consolidation& consolidation, double voxel)
{
  const LargeVector<Representative>& all = consolidation.representatives;
  if (all.empty())
    return {};
  DeWallSettings settings;
  settings.rule = DeWallRule::Guarded;
  settings.maximum_edge_length = 2.5 * voxel;
  DeWallInput input;
  input.points =
      PointView(all.front().point.data(), sizeof(Representative), all.size());
  input.normals =
      PointView(all.front().normal.data(), sizeof(Representative), all.size());
  input.threads = 1;
  DeWallReport report;
  return triangulateDeWall(input, settings, Progress(), report);
}

test::Points
placesInScene(const SimulatedCloud& cloud, const Consolidation& consolidation)
{
  test::Points places;
  for (const Representative& representative : consolidation.representatives)
    places.push_back(cloud.T_scene_cloud * representative.point.cast<double>());
  return places;
}

test::Points
normalsInScene(const SimulatedCloud& cloud, const Consolidation& consolidation)
{
  test::Points normals;
  for (const Representative& representative : consolidation.representatives)
    normals.push_back(cloud.T_scene_cloud.linear() *
                      representative.normal.cast<double>());
  return normals;
}

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
