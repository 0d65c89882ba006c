#include "normal_tables.h"

#include "consolidated_mesh.h"
#include "crease_scores.h"
#include "markdown_row.h"
#include "voted_mesh.h"

#include <iostream>
#include <sstream>

namespace pcl::acmap::bench {
namespace {

constexpr double reach = 0.9;

std::string
weightName(double weight)
{
  std::ostringstream name;
  name << weight;
  return name.str();
}

void
printRow(const SimulatedCloud& cloud,
         const VotedMesh& voted,
         double weight,
         const CreaseScores& scores,
         bool is_default)
{
  MarkdownRow()
      .text(cloud.name)
      .text(weightName(weight) + (is_default ? " (default)" : ""))
      .number(100 * voted.report.voxel_size, 1)
      .count(voted.votes.normals.size())
      .count(scores.found)
      .atLeast(scores.precision, is_default ? reach : no_reach, 3)
      .number(scores.length, 1)
      .atLeast(scores.recall, is_default ? reach : no_reach, 3)
      .count(scores.near_edges)
      .number(scores.recall_of_nearest, 3)
      .print();
}

void
printCreases(const SimulatedCloud& cloud, const SceneTruth& truth)
{
  constexpr double pages_weight = 2;
  const VotedMesh voted = meshAndVote(cloud);
  const test::Points places = placesInScene(cloud, voted.consolidation);
  VotingSettings settings;
  const double default_weight = settings.crease_weight;
  for (const double weight : {default_weight, pages_weight}) {
    settings.crease_weight = weight;
    printRow(cloud,
             voted,
             weight,
             scoreCreases(truth,
                          places,
                          creasesOf(voteAgain(voted, settings)),
                          voted.report.voxel_size,
                          voted.report.sigma),
             weight == default_weight);
  }
}

} // namespace

void
printCreases(SceneData& corridor)
{
  std::cout << "\n### Creases\n";
  printHead({"cloud",
             "crease weight",
             "voxel, cm",
             "vertices",
             "creases and corners",
             "precision",
             "true edges seen, m",
             "recall",
             "vertices within half a voxel of them",
             "recall of these"});
  constexpr std::size_t view = 0;
  printCreases(makeViewCloud(corridor.scene(), view), corridor.truthOfView(view));
  printCreases(makeRandomPart(corridor.whole(), 1000000, 1), corridor.wholeTruth());
  printCreases(corridor.whole(), corridor.wholeTruth());
}

} // namespace pcl::acmap::bench
