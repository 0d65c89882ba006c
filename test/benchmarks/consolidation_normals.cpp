#include "consolidation_tables.h"

#include "consolidated_mesh.h"
#include "cpu_time.h"
#include "markdown_row.h"
#include "mesh_figures.h"
#include "peer_normals.h"

#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr double median_reach = 1; // degrees
constexpr double p95_reach = 6;

void
printRow(const std::string& name,
         const NormalErrors& errors,
         double seconds,
         const SimulatedCloud& cloud,
         bool is_ours)
{
  MarkdownRow()
      .text(name)
      .atMost(errors.median_away, is_ours ? median_reach : no_reach, 2)
      .atMost(errors.p95_away, is_ours ? p95_reach : no_reach, 1)
      .number(errors.backs_away, 2)
      .number(errors.median_all, 2)
      .number(errors.p95_all, 1)
      .number(errors.backs_all, 2)
      .number(1e6 * seconds / static_cast<double>(cloud.size()), 3)
      .print();
}

/** \return the edge length of a voxel */
double
printOurs(const SimulatedCloud& cloud, double voxel, const SceneTruth& truth)
{
  ConsolidationReport report;
  const double begin = threadSeconds();
  const Consolidation consolidation = consolidate(cloud, voxel, report);
  const double seconds = threadSeconds() - begin;
  printRow(cloud.name + ", representatives, " + voxelName(voxel),
           measureNormals(truth,
                          placesInScene(cloud, consolidation),
                          normalsInScene(cloud, consolidation),
                          report.voxel_size),
           seconds,
           cloud,
           true);
  return report.voxel_size;
}

void
printPeer(const PeerNormals& peer,
          const SimulatedCloud& cloud,
          const SceneTruth& truth,
          double voxel)
{
  printRow(cloud.name + ", " + peer.name,
           measureNormals(truth, peer.places, peer.normals, voxel),
           peer.seconds,
           cloud,
           false);
}

} // namespace

void
printNormals(SceneData& corridor)
{
  std::cout << "\n### Normals\n";
  printHead({"cloud, normals",
             "away from creases, median °",
             "p95 °",
             "backs %",
             "all, median °",
             "p95 °",
             "backs %",
             "CPU us a point"});
  const SceneTruth truth(corridor.scene());
  for (const std::size_t view : {0, 40, 53}) {
    const SimulatedCloud cloud = makeViewCloud(corridor.scene(), view);
    const double voxel = printOurs(cloud, 0, truth);
    if (view > 0)
      continue;
    constexpr int neighbours = 16;
    constexpr double radius = 0.1;
    printPeer(normalsOfNearest(cloud, neighbours), cloud, truth, voxel);
    printPeer(normalsWithin(cloud, radius), cloud, truth, voxel);
  }
  for (const double voxel : {0.05, 0.0})
    printOurs(corridor.whole(), voxel, truth);
}

} // namespace pcl::acmap::bench
