#include "plane_tables.h"

#include "markdown_row.h"
#include "plane_scores.h"

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace pcl::acmap::bench {
namespace {

/** Sums over several views. */
struct ViewsScore {
  std::string name;
  FoundShare main, large;
  std::size_t spurious = 0;
  std::size_t duplicates = 0;
  double largest_angle = 0; ///< degrees, of main planes
  double largest_offset = 0;
  double labels = 0; ///< percent
  double seconds = 0;

  void
  add(const PlaneScores& view)
  {
    main.found += view.main.found;
    main.there += view.main.there;
    large.found += view.large.found;
    large.there += view.large.there;
    spurious += view.spurious;
    duplicates += view.duplicates;
    // fmax ignores NaN, for views without main planes
    largest_angle = std::fmax(largest_angle, view.main_errors.largest_angle);
    largest_offset = std::fmax(largest_offset, view.main_errors.largest_offset);
    labels += view.large_labels;
    seconds += view.seconds;
  }
};

std::string
textOf(const FoundShare& share)
{
  return std::to_string(share.found) + " of " + std::to_string(share.there);
}

void
printViews(const std::vector<ViewsScore>& all, std::size_t views)
{
  printHead({"finder",
             "main planes found",
             "planes with 0.3 % of the points",
             "spurious",
             "duplicates",
             "main planes: largest angle, degrees",
             "largest offset, mm",
             "labels right %",
             "CPU s a view"});
  for (const ViewsScore& one : all)
    MarkdownRow()
        .text(one.name)
        .text(textOf(one.main))
        .text(textOf(one.large))
        .count(one.spurious)
        .count(one.duplicates)
        .number(one.largest_angle, 3)
        .number(1000 * one.largest_offset, 2)
        .number(one.labels / static_cast<double>(views), 2)
        .number(one.seconds / static_cast<double>(views), 3)
        .print();
}

} // namespace

void
printAllViewsPlanes(const SceneData& corridor, const NamedFinders& finders)
{
  constexpr std::size_t first = 0, last = 105, step = 7;
  std::vector<ViewsScore> all;
  for (const NamedFinder& finder : finders)
    all.push_back({finder.name, {}, {}});
  std::size_t views = 0;
  for (std::size_t view = first; view <= last; view += step, ++views) {
    const PlaneCase plane_case = makePlaneCase(makeViewCloud(corridor.scene(), view));
    for (std::size_t f = 0; f < finders.size(); ++f)
      all[f].add(scorePlanes(plane_case, finders[f].find(plane_case.input)));
  }
  std::cout << "\n### Every seventh view of the corridor, " << views << " in all\n";
  printViews(all, views);
}

} // namespace pcl::acmap::bench
