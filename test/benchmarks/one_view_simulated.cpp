#include "one_view_tables.h"
#include "units.h"

#include "markdown_row.h"
#include "one_view_finders.h"
#include "plane_matches.h"
#include "segment_scores.h"
#include "statistics.h"

#include <pcl/simulation/standard_scenes.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t main_pixels = 2000;      // minimum for a main plane
constexpr MatchLimits found_limits{5.0, 0.05}; // degrees, metres

/** \brief Sums over several views. */
struct ViewScores {
  std::size_t views = 0;
  std::size_t main = 0;     ///< true main planes
  std::size_t found = 0;    ///< of these, found
  std::size_t spurious = 0; ///< less than half of the points from one true plane
  std::size_t astray = 0;   ///< from one true plane, but with a large deviation
  std::size_t duplicates = 0;
  std::vector<double> angles;  ///< degrees, of the main planes that were found
  std::vector<double> offsets; ///< metres
  double labels = 0;           ///< percent, summed
  double seconds = 0;

  void
  add(const TrueView& seen, const FoundPlanes& result)
  {
    const PlaneCase plane_case{seen.view.name, seen.view.finite, seen.truth};
    const PlaneOverlaps overlaps(seen.truth.labels,
                                 seen.truth.planes.size(),
                                 result.labels,
                                 result.planes.size());
    const PlaneMatches matches =
        matchPlanes(plane_case, result, overlaps, found_limits);
    for (std::size_t t = 0; t < seen.truth.planes.size(); ++t) {
      if (overlaps.truthSize(t) < main_pixels)
        continue;
      ++main;
      if (matches.finder[t] < 0)
        continue;
      ++found;
      angles.push_back(matches.deviation[t].angle);
      offsets.push_back(matches.deviation[t].offset);
    }
    ++views;
    spurious += matches.spurious - matches.astray;
    astray += matches.astray;
    duplicates += matches.duplicates;
    labels += scoreSegments(overlaps, main_pixels).labels;
    seconds += result.seconds;
  }

  void
  print(const std::string& scene, const std::string& finder) const
  {
    const auto count = static_cast<double>(views);
    MarkdownRow()
        .text(scene)
        .text(finder)
        .text(std::to_string(found) + " of " + std::to_string(main))
        .count(spurious)
        .count(astray)
        .count(duplicates)
        .number(median(angles), 2)
        .number(quantile(angles, 1), 2)
        .number(milli * median(offsets), 1)
        .number(milli * quantile(offsets, 1), 1)
        .number(labels / count, 1)
        .number(seconds / count, 3)
        .print();
  }
};

/** \brief Runs all methods on the first views of a scene. */
void
addScene(const std::string& name,
         const std::vector<OneViewFinder>& finders,
         std::vector<ViewScores>& of_scene,
         std::vector<ViewScores>& of_all)
{
  constexpr std::size_t views = 10;
  SimulatedScene scene = standardScene(name);
  useKinect(scene);
  for (std::size_t view = 0; view < views; ++view) {
    const TrueView seen = makeTrueView(scene, view);
    for (std::size_t f = 0; f < finders.size(); ++f) {
      const FoundPlanes found = finders[f].find(seen.view);
      of_scene[f].add(seen, found);
      of_all[f].add(seen, found);
    }
  }
}

} // namespace

void
printSimulatedViews()
{
  std::vector<OneViewFinder> finders;
  for (const OneViewFinder& finder : oneViewFinders())
    if (!finder.is_slow)
      finders.push_back(finder);
  std::cout << "\n### Simulated Kinect\n";
  printHead({"views",
             "finder",
             "main planes found",
             "spurious",
             "too far off",
             "duplicates",
             "angle, median °",
             "largest",
             "offset, median mm",
             "largest",
             "labels right %",
             "CPU s a view"});
  std::vector<ViewScores> of_all(finders.size());
  for (const char* const name : {"office", "corridor", "loop"}) {
    std::vector<ViewScores> of_scene(finders.size());
    addScene(name, finders, of_scene, of_all);
    for (std::size_t f = 0; f < finders.size(); ++f)
      of_scene[f].print(name, finders[f].name);
  }
  for (std::size_t f = 0; f < finders.size(); ++f)
    of_all[f].print("all 30", finders[f].name);
}

} // namespace pcl::acmap::bench
