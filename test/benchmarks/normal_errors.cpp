#include "normal_tables.h"

#include "consolidated_mesh.h"
#include "markdown_row.h"
#include "mesh_figures.h"
#include "peer_normals.h"
#include "voted_mesh.h"

#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr double median_reach = 0.5; // degrees
constexpr double p95_reach = 5;

void
printRow(const std::string& cloud,
         const std::string& name,
         const NormalErrors& errors,
         bool is_ours = false)
{
  MarkdownRow()
      .text(cloud)
      .text(name)
      .atMost(errors.median_away, is_ours ? median_reach : no_reach, 2)
      .atMost(errors.p95_away, is_ours ? p95_reach : no_reach, 1)
      .number(errors.backs_away, 2)
      .number(errors.median_all, 2)
      .number(errors.p95_all, 1)
      .number(errors.backs_all, 2)
      .print();
}

/** \return the edge length of a voxel */
double
printErrors(const SimulatedCloud& cloud, const SceneTruth& truth)
{
  const VotedMesh voted = meshAndVote(cloud);
  const double voxel = voted.report.voxel_size;
  const test::Points places = placesInScene(cloud, voted.consolidation);
  printRow(cloud.name,
           "NormalVectorVoting",
           measureNormals(truth, places, votedNormalsInScene(cloud, voted), voxel),
           true);
  printRow(
      cloud.name,
      "VoxelConsolidation",
      measureNormals(truth, places, normalsInScene(cloud, voted.consolidation), voxel));
  return voxel;
}

} // namespace

void
printVotedNormals(SceneData& corridor)
{
  std::cout << "\n### Voted normals\n";
  printHead({"cloud",
             "normals",
             "away from creases, median °",
             "p95 °",
             "backs %",
             "all, median °",
             "p95 °",
             "backs %"});
  const SceneTruth truth(corridor.scene());
  const SimulatedCloud view = makeViewCloud(corridor.scene(), 0);
  const double voxel = printErrors(view, truth);
  constexpr int neighbours = 16;
  constexpr double radius = 0.1;
  for (const PeerNormals& peer :
       {normalsOfNearest(view, neighbours), normalsWithin(view, radius)})
    printRow(
        view.name, peer.name, measureNormals(truth, peer.places, peer.normals, voxel));
  printErrors(makeRandomPart(corridor.whole(), 1000000, 1), truth);
  printErrors(corridor.whole(), truth);
}

} // namespace pcl::acmap::bench
