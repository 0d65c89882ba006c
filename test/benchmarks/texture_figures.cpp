#include "image_similarity.h"
#include "map_raycast.h"
#include "markdown_row.h"
#include "sections.h"
#include "simulated_clouds.h"
#include "temporary_folder.h"
#include "texture_seams.h"
#include "timing.h"
#include "voted_hypotheses.h"
#include "voted_mesh.h"

#include "atlas/chart_picture.h"
#include "texturing/canvas_painting.h"

#include <pcl/core/random.h>
#include <pcl/texture/compact_map_folder.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <set>

namespace pcl::acmap::bench {
namespace {

constexpr char usage[] =
    "Usage: acmap_bench_texture_figures [views] [exposure] [stored]\n"
    "Prints how well the views of the corridor are drawn again from its compact map,\n"
    "and what is seen of the borders between views, as Markdown tables. With exposure "
    "the\n"
    "views are brighter and darker by up to a quarter; with stored the map is saved "
    "with\n"
    "several tolerances of its colours and loaded again.\n";

constexpr std::uint64_t seed = 1;

std::vector<PlanePatch>
planesOf(const SimulatedCloud& cloud)
{
  const VotedMesh voted = meshAndVote(cloud);
  PlaneHypotheses hypotheses;
  hypotheses.points = voted.vertices();
  hypotheses.triangles = voted.mesh.triangles;
  addVotes(voted.votes, hypotheses);
  PlaneClusteringSettings settings;
  settings.noise_driven = true;
  settings.plane_distance = 0;
  settings.threads = 1;
  PlaneClusteringReport report;
  return clusterPlanes(hypotheses,
                       {cloud.points(), cloud.sensors()},
                       settings,
                       Progress(),
                       report)
      .patches;
}

std::uint32_t
brightened(std::uint32_t rgb, double gain)
{
  std::uint32_t result = 0;
  for (const int shift : {0, 8, 16}) {
    const double value = gain * ((rgb >> shift) & 0xff);
    result |= static_cast<std::uint32_t>(std::lround(std::min(value, 255.0))) << shift;
  }
  return result;
}

/** An observation with a brightness factor. */
SimulatedObservation
observeWith(const SimulatedScene& scene, std::size_t view, double gain)
{
  SimulatedObservation observation = observe(scene, view, seed);
  for (ObservationPixel& pixel : observation.pixels)
    pixel.rgb = brightened(pixel.rgb, gain);
  return observation;
}

ColoredView
viewOf(const SimulatedObservation& observation, const Eigen::Isometry3d& pose)
{
  ColoredView view;
  view.points = PointView(&observation.pixels.front().x,
                          sizeof(ObservationPixel),
                          observation.pixels.size());
  view.colors = {&observation.pixels.front().rgb, sizeof(ObservationPixel)};
  view.width = observation.width;
  view.T_map_camera = pose;
  return view;
}

/** A map with the observations from which it was textured. */
struct Painted {
  std::vector<texturing::Canvas> canvases;
  CompactMap map;
  std::vector<double> gains;
  double seconds = 0; ///< CPU time without the simulation
};

Painted
paint(const SimulatedScene& scene,
      const Trajectory& trajectory,
      const std::vector<PlanePatch>& planes,
      const std::vector<double>& exposures)
{
  const TexturingSettings settings;
  Painted painted;
  std::size_t left_out = 0;
  painted.canvases = texturing::canvasesOf(
      planes, {}, settings.texel_size, settings.maximum_texture_size, left_out);
  for (texturing::Canvas& canvas : painted.canvases)
    canvas.samples.resize(canvas.mask.size());
  for (std::size_t v = 0; v < trajectory.poses.size(); ++v) {
    const SimulatedObservation seen = observeWith(scene, v, exposures[v]);
    const ColoredView view = viewOf(seen, trajectory.poses[v]);
    painted.seconds +=
        measureCost([&] {
          const auto nearest = texturing::nearestCanvases(view,
                                                          painted.canvases,
                                                          settings.maximum_distance,
                                                          texturing::TexelPlace::Rim);
          texturing::paintPinhole(
              view,
              *fitUprightPinhole(view.points, static_cast<std::size_t>(view.width)),
              static_cast<std::int32_t>(v),
              nearest,
              painted.canvases);
        }).cpu;
  }
  painted.seconds +=
      measureCost([&] {
        painted.gains =
            texturing::exposureGains(painted.canvases, trajectory.poses.size());
        for (const texturing::Canvas& canvas : painted.canvases) {
          TextureChart& chart = painted.map.charts.emplace_back(canvas.chart);
          texturing::blend(painted.gains, canvas, chart);
          texturing::fillHoles(settings.fill_distance, canvas.mask, chart);
        }
      }).cpu;
  painted.map.planes = planes;
  return painted;
}

/** Mean similarity of some views with renderings of the map from the same poses. */
Similarity
redraw(const SimulatedScene& scene,
       const Trajectory& trajectory,
       const Painted& painted,
       const std::vector<double>& exposures)
{
  Similarity all;
  constexpr std::size_t step = 15;
  double views = 0;
  for (std::size_t v = 0; v < trajectory.poses.size(); v += step, ++views) {
    const SimulatedObservation seen =
        observeWith(scene, v, exposures[v] * painted.gains[v]);
    const RaycastImage drawn = castMap(painted.map, scene.rig, trajectory.poses[v]);
    std::vector<std::uint8_t> rgb;
    for (const ObservationPixel& pixel : seen.pixels)
      for (const int shift : {16, 8, 0})
        rgb.push_back(static_cast<std::uint8_t>(pixel.rgb >> shift));
    const Similarity one = structuralSimilarity(
        rgb, drawn.rgb, drawn.is_known, static_cast<std::size_t>(seen.width));
    all.mean += one.mean;
    all.windows += one.windows;
  }
  all.mean /= views;
  return all;
}

/** Relative RMS of the remaining exposure differences after the gains; a common factor
 * is ignored. */
double
unbalanced(const std::vector<double>& gains, const std::vector<double>& exposures)
{
  double sum = 0, squares = 0;
  const auto count = static_cast<double>(gains.size());
  for (std::size_t v = 0; v < gains.size(); ++v) {
    const double rest = std::log(gains[v] * exposures[v]);
    sum += rest;
    squares += rest * rest;
  }
  return std::sqrt(squares / count - sum / count * (sum / count));
}

void
printRow(const std::string& name,
         const SimulatedScene& scene,
         const Trajectory& trajectory,
         const std::vector<PlanePatch>& planes,
         const std::vector<double>& exposures)
{
  constexpr double min_similarity = 0.9, max_steps = 1.5;
  const Painted painted = paint(scene, trajectory, planes, exposures);
  const Similarity similarity = redraw(scene, trajectory, painted, exposures);
  constexpr std::int32_t deep = 5; // texels
  const SeamSteps all = measureSeams(painted.canvases, painted.map.charts, 0);
  const SeamSteps steps = measureSeams(painted.canvases, painted.map.charts, deep);
  std::size_t texels = 0;
  for (const TextureChart& chart : painted.map.charts)
    texels += chart.kinds.size();
  MarkdownRow()
      .text(name)
      .count(trajectory.poses.size())
      .count(painted.map.charts.size())
      .count(texels)
      .atLeast(similarity.mean, min_similarity, 3)
      .number(steps.across, 2)
      .number(steps.inside, 2)
      .atMost(steps.across / steps.inside, max_steps, 2)
      .atMost(all.across / all.inside, max_steps, 2)
      .number(100 * unbalanced(painted.gains, exposures), 2)
      .number(painted.seconds, 1)
      .print();
}

/** Differences of the known texels of two maps, levels of 255. */
struct ColorErrors {
  double rms = 0;
  double most_of_999 = 0; ///< of 99.9 % of the texels, the largest of a channel
};

ColorErrors
errorsOf(const CompactMap& stored, const CompactMap& painted)
{
  std::array<std::size_t, 256> counts{};
  double squares = 0;
  std::size_t texels = 0;
  for (std::size_t c = 0; c < painted.charts.size(); ++c) {
    const TextureChart& chart = painted.charts[c];
    for (std::size_t t = 0; t < chart.kinds.size(); ++t) {
      if (chart.kinds[t] == TexelKind::None)
        continue;
      int largest = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const int off = std::abs(int{chart.colors.values[3 * t + k]} -
                                 int{stored.charts[c].colors.values[3 * t + k]});
        largest = std::max(largest, off);
        squares += off * off / 3.0;
      }
      ++counts[static_cast<std::size_t>(largest)];
      ++texels;
    }
  }
  ColorErrors errors;
  errors.rms = std::sqrt(squares / static_cast<double>(texels));
  std::size_t level = 0;
  for (std::size_t sum = counts[0]; 1000 * sum < 999 * texels; sum += counts[level])
    ++level;
  errors.most_of_999 = static_cast<double>(level);
  return errors;
}

/** The map with its colours as they are stored with some tolerances. */
void
printStored(const SimulatedScene& scene,
            const Trajectory& trajectory,
            const std::vector<PlanePatch>& planes)
{
  const std::vector<double> exposures(trajectory.poses.size(), 1.0);
  Painted painted = paint(scene, trajectory, planes, exposures);
  painted.map.exposure = texturing::displayExposure(painted.map);
  printHead({"color_tolerance",
             "texels in the pages, %",
             "charts of one texel",
             "map.glb, bytes",
             "difference, rms",
             "99.9 % of the texels",
             "SSIM of views drawn again",
             "saving, CPU s"});
  for (const double tolerance : {0.0, 0.75, 1.5, 3.0}) {
    const test::TemporaryFolder folder;
    CompactMapOutputs outputs;
    outputs.color_tolerance = tolerance;
    const double seconds = measureCost([&] {
                             saveCompactMap(folder.path("map"), painted.map, outputs);
                           }).cpu;
    std::int64_t all = 0, kept = 0;
    std::size_t single = 0;
    for (const TextureChart& chart : painted.map.charts) {
      const auto size = halvedSize(chart.colors, chart.halvings).cast<std::int64_t>();
      all += std::int64_t{chart.colors.width} * chart.colors.height;
      kept += size.prod();
      single += size.prod() == 1 ? 1 : 0;
    }
    Painted stored;
    stored.map = loadCompactMap(folder.path("map"));
    stored.gains = painted.gains;
    const ColorErrors errors = errorsOf(stored.map, painted.map);
    MarkdownRow()
        .number(tolerance, 2)
        .number(100 * static_cast<double>(kept) / static_cast<double>(all), 1)
        .count(single)
        .count(std::filesystem::file_size(folder.path("map/map.glb")))
        .number(errors.rms, 2)
        .number(errors.most_of_999, 0)
        .number(redraw(scene, trajectory, stored, exposures).mean, 3)
        .number(seconds, 2)
        .print();
  }
}

std::vector<double>
randomExposures(std::size_t views)
{
  Random random(seed);
  std::vector<double> exposures;
  for (std::size_t v = 0; v < views; ++v)
    exposures.push_back(std::exp(random.uniform(-0.22, 0.22)));
  return exposures;
}

} // namespace
} // namespace pcl::acmap::bench

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  Sections sections;
  if (const auto exit_code =
          Sections::read(argc, argv, {"views", "exposure", "stored"}, usage, sections))
    return *exit_code;
  SceneData corridor("corridor");
  const SimulatedCloud& whole = corridor.whole();
  const std::vector<pcl::PlanePatch> planes = planesOf(whole);
  const pcl::Trajectory& trajectory = whole.merged.trajectory;
  if (sections.isWanted("views") || sections.isWanted("exposure"))
    printHead({"views",
               "number",
               "charts",
               "texels",
               "SSIM of views drawn again",
               "10 cm from rims: step across borders of views",
               "inside",
               "ratio",
               "ratio everywhere",
               "exposure left, %",
               "CPU s"});
  if (sections.isWanted("views"))
    printRow("as they are",
             corridor.scene(),
             trajectory,
             planes,
             std::vector<double>(trajectory.poses.size(), 1.0));
  if (sections.isWanted("exposure"))
    printRow("brighter and darker",
             corridor.scene(),
             trajectory,
             planes,
             randomExposures(trajectory.poses.size()));
  if (sections.isWanted("stored")) {
    std::cout << '\n';
    printStored(corridor.scene(), trajectory, planes);
  }
  return 0;
}
