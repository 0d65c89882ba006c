#include "normal_tables.h"

#include "markdown_row.h"
#include "peer_normals.h"
#include "statistics.h"
#include "timing.h"
#include "voted_mesh.h"

#include <cmath>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr double min_ratio = 20;

/** Median times of each step over several rounds. */
struct TimedVoting {
  VotingSeconds seconds;
  double votes_with_curvatures = 0;
  std::size_t vertices = 0;
};

TimedVoting
timeVoting(const SimulatedCloud& cloud, std::size_t rounds)
{
  std::vector<double> consolidation, mesh, votes, curvatures;
  TimedVoting timed;
  for (std::size_t round = 0; round < rounds; ++round) {
    const VotedMesh voted = meshAndVote(cloud);
    consolidation.push_back(voted.seconds.consolidation);
    mesh.push_back(voted.seconds.mesh);
    votes.push_back(voted.seconds.votes);
    VotingSettings settings;
    settings.compute_curvatures = true;
    curvatures.push_back(measureThread([&] { voteAgain(voted, settings); }));
    timed.vertices = voted.votes.normals.size();
  }
  timed.seconds = {median(consolidation), median(mesh), median(votes)};
  timed.votes_with_curvatures = median(curvatures);
  return timed;
}

/** \param[in] peer CPU seconds per point of the compared method; NaN for none */
void
printRow(const SimulatedCloud& cloud,
         const std::string& name,
         std::size_t vertices,
         double seconds,
         double peer)
{
  const double each = seconds / static_cast<double>(cloud.size());
  MarkdownRow row;
  row.text(cloud.name)
      .count(cloud.size())
      .text(name)
      .number(1e6 * each, 4)
      .number(1e6 * seconds / static_cast<double>(vertices), 2);
  if (std::isnan(peer))
    row.text("");
  else
    row.atLeast(peer / each, min_ratio, 1);
  row.print();
}

void
printRows(const SimulatedCloud& cloud, std::size_t rounds, double peer)
{
  const TimedVoting timed = timeVoting(cloud, rounds);
  const auto print = [&](const std::string& name, double seconds, double held) {
    printRow(cloud, name, timed.vertices, seconds, held);
  };
  print("consolidation", timed.seconds.consolidation, no_reach);
  print("mesh", timed.seconds.mesh, no_reach);
  print("votes", timed.seconds.votes, no_reach);
  print("votes and curvatures", timed.votes_with_curvatures, no_reach);
  print("consolidation, mesh and votes", timed.seconds.sum(), peer);
}

} // namespace

void
printVotingTime(SceneData& corridor, std::size_t rounds)
{
  constexpr std::size_t few_rounds = 3;
  constexpr int neighbours = 16;
  constexpr double radius = 0.1;
  std::cout << "\n### Time of voting\n";
  printHead({"cloud",
             "points",
             "what",
             "CPU us a point",
             "CPU us a vertex",
             "times as fast as radius 10 cm on view 0"});
  const SimulatedCloud view = makeViewCloud(corridor.scene(), 0);
  const PeerNormals nearest = normalsOfNearest(view, neighbours);
  const PeerNormals within = normalsWithin(view, radius);
  for (const PeerNormals* peer : {&nearest, &within})
    printRow(view, peer->name, view.size(), peer->seconds, no_reach);
  const double each = within.seconds / static_cast<double>(view.size());
  printRows(view, rounds, each);
  printRows(makeRandomPart(corridor.whole(), 1000000, 1), rounds, each);
  printRows(corridor.whole(), few_rounds, each);
}

} // namespace pcl::acmap::bench
