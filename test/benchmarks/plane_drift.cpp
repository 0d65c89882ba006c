#include "plane_tables.h"

#include "markdown_row.h"
#include "plane_scores.h"

#include <pcl/core/random.h>

#include <iostream>
#include <string>
#include <vector>

namespace pcl::acmap::bench {
namespace {

/** Moves each observation by a random walk, which simulates poses without
 * rectification.
 * \param[in] step standard deviation along each axis from one observation to the next,
 * metres */
void
letDrift(double step, std::uint64_t seed, PlaneInput& input)
{
  Random random(seed);
  std::vector<Eigen::Vector3f> drift;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (Eigen::Vector3f& origin : input.origins) {
    for (int axis = 0; axis < 3; ++axis)
      place[axis] += step * random.normal();
    drift.push_back(place.cast<float>());
    origin += drift.back();
  }
  for (std::size_t i = 0; i < input.points->size(); ++i)
    (*input.points)[i].getVector3fMap() +=
        drift[static_cast<std::size_t>(input.views[i])];
}

void
printRow(const std::string& scene, double step, const std::vector<PlaneScores>& runs)
{
  FoundShare large;
  std::size_t given = 0, duplicates = 0, spurious = 0;
  for (const PlaneScores& run : runs) {
    large.found += run.large.found;
    large.there += run.large.there;
    given += run.given;
    duplicates += run.duplicates;
    spurious += run.spurious;
  }
  MarkdownRow()
      .text(scene)
      .number(1000 * step, 0)
      .text(std::to_string(large.found) + " of " + std::to_string(large.there))
      .count(given)
      .count(duplicates)
      .count(spurious)
      .print();
}

} // namespace

void
printDriftPlanes(const NamedFinder& finder)
{
  constexpr std::uint64_t seeds = 3;
  constexpr std::size_t points = 1000000;
  std::cout << "\n### Maps whose poses drift\n\n"
            << seeds
            << " random walks each, summed up (one map where the poses are right)\n";
  printHead({"scene",
             "drift, mm an observation",
             "planes with 0.3 % of the points",
             "planes given",
             "duplicates",
             "spurious"});
  for (const std::string& scene :
       std::vector<std::string>{"office", "l_corridor", "corridor_survey"}) {
    SceneData data(scene);
    const SimulatedCloud part = makeRandomPart(data.whole(), points, 1);
    for (const double step : {0.0, 0.005, 0.01}) {
      std::vector<PlaneScores> runs;
      for (std::uint64_t seed = 1; seed <= (step > 0 ? seeds : 1); ++seed) {
        PlaneCase plane_case = makePlaneCase(part);
        letDrift(step, seed, plane_case.input);
        runs.push_back(scorePlanes(plane_case, findPlanes(finder, plane_case.input)));
      }
      printRow(scene, step, runs);
    }
  }
}

} // namespace pcl::acmap::bench
