#include "outline_tables.h"

#include "markdown_row.h"
#include "outline_scores.h"
#include "statistics.h"
#include "units.h"

#include <pcl/simulation/standard_scenes.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

/** \brief A simulated scene whose outlines were judged. */
struct JudgedScene {
  std::string name;
  OutlineCounts counts;
  OutlineScores scores;
  double seen = 0;    ///< square metres, of all true planes
  double seconds = 0; ///< of the outlines
};

/** \brief A scene whose sensor gives a point for every pixel in reach. */
SimulatedScene
withAllPixels(SimulatedScene scene)
{
  scene.sensor.points = static_cast<std::size_t>(scene.rig.width) *
                        static_cast<std::size_t>(scene.rig.height);
  scene.sensor.views_with_one_more = 0;
  return scene;
}

JudgedScene
judge(const std::string& name,
      const SimulatedScene& scene,
      const VisibleTruth& truth,
      const OutlineOptions& options)
{
  const JudgedMap map =
      makeJudgedMap(name, options, [&] { return observeScene(scene); });
  const std::vector<PlaneOutline> outlines =
      makeOutlines(map.planes, scene.views.front());
  return {name,
          countOutlines(outlines),
          scoreOutlines(outlines, truth),
          truth.seenArea(),
          map.seconds};
}

double
share(double part, double whole)
{
  return 100 * part / whole;
}

void
printCreases(const std::vector<JudgedScene>& scenes)
{
  printHead({"scene",
             "planes",
             "matched",
             "true creases, m",
             "of planes found, m",
             "of these shared exactly %",
             "of all %",
             "gap above 1 cm, m",
             "corners",
             "error, median, mm",
             "95 %",
             "vertices a plane, mean",
             "median",
             "polygons that cross themselves",
             "holes",
             "slivers",
             "outlines, CPU s"});
  for (const JudgedScene& scene : scenes) {
    const OutlineScores& scores = scene.scores;
    const auto spurious = std::count(
        scores.face_of_plane.begin(), scores.face_of_plane.end(), std::int32_t{-1});
    MarkdownRow()
        .text(scene.name)
        .count(scene.counts.planes)
        .count(scene.counts.planes - static_cast<std::size_t>(spurious))
        .number(scores.creases, 1)
        .number(scores.found, 1)
        .number(share(scores.shared, scores.found), 1)
        .number(share(scores.shared, scores.creases), 1)
        .number(scores.gaps, 2)
        .count(scores.corners.size())
        .number(milli * median(scores.corners), 1)
        .number(milli * quantile(scores.corners, 0.95), 0)
        .number(scene.counts.vertices_mean, 1)
        .number(scene.counts.vertices_median, 0)
        .count(scene.counts.crossed)
        .count(scene.counts.holes)
        .count(scene.counts.slivers)
        .number(scene.seconds, 3)
        .print();
  }
}

void
printAreas(const std::vector<JudgedScene>& scenes)
{
  printHead({"scene",
             "seen, m²",
             "of planes found, m²",
             "IoU",
             "seen but missing %",
             "deeper than 5 cm, m²",
             "surplus, unseen surface %",
             "surplus over nothing %",
             "deeper than 5 cm, m²",
             "planes of no face, m²",
             "area : seen area"});
  for (const JudgedScene& scene : scenes) {
    const OutlineScores& scores = scene.scores;
    MarkdownRow()
        .text(scene.name)
        .number(scene.seen, 1)
        .number(scores.seen, 1)
        .number(scores.common / scores.joined, 4)
        .number(share(scores.missing, scores.seen), 2)
        .number(scores.missing_inside, 3)
        .number(share(scores.unseen, scores.seen), 2)
        .number(share(scores.nothing, scores.seen), 2)
        .number(scores.nothing_inside, 3)
        .number(scores.unmatched_area, 2)
        .number(scene.counts.area / scene.seen, 3)
        .print();
  }
}

} // namespace

void
printSimulatedOutlines(const std::vector<std::string>& names,
                       const OutlineOptions& options)
{
  std::vector<JudgedScene> scenes;
  for (const std::string& name : names) {
    const SimulatedScene scene = standardScene(name);
    const VisibleTruth truth = findVisibleTruth(scene);
    scenes.push_back(judge(name, scene, truth, options));
    scenes.push_back(judge(name + "_all_pixels", withAllPixels(scene), truth, options));
  }
  std::cout << "\n### Outlines of simulated scenes\n";
  printCreases(scenes);
  printAreas(scenes);
}

} // namespace pcl::acmap::bench
