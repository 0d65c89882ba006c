#include "bench.h"
#include "map_views.h"
#include "meshes.h"
#include "simulated_clouds.h"
#include "texturing/canvas.h"
#include "texturing/canvas_painting.h"
#include "voted_hypotheses.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/random.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/simulation/ray_casting.h>

#include <Eigen/Geometry>

namespace pcl::acmap::bench {
namespace {

/** \brief Brightness differences between neighbouring observed texels, of 255. */
struct SeamSteps {
  double across = 0;       ///< mean if the best samples are from two views
  double inside = 0;       ///< mean if they are from one view
  std::size_t borders = 0; ///< pairs of texels with two views
};

double
step(const TextureChart& chart, std::size_t a, std::size_t b)
{
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += chart.colors.values[3 * a + k] - chart.colors.values[3 * b + k];
  return std::abs(sum) / 3;
}

bool
isDeep(const texturing::Canvas& canvas, std::size_t texel, std::int32_t from_rim)
{
  const std::int32_t width = canvas.chart.colors.width;
  const auto column = static_cast<std::int32_t>(texel) % width;
  const auto row = static_cast<std::int32_t>(texel) / width;
  for (const std::int32_t way : {-from_rim, 0, from_rim})
    for (const std::int32_t aside : {-from_rim, 0, from_rim}) {
      const std::int32_t c = column + way, r = row + aside;
      if (c < 0 || r < 0 || c >= width || r >= canvas.chart.colors.height ||
          canvas.mask[canvas.index(c, r)] != texturing::TexelPlace::Inside)
        return false;
    }
  return true;
}

/** \param[in] from_rim minimum distance from the polygon's border in texels: at creases
 * and depth edges the views disagree about the extent of the plane */
SeamSteps
measureSeams(const std::vector<texturing::Canvas>& canvases,
             const std::vector<TextureChart>& charts,
             std::int32_t from_rim)
{
  SeamSteps steps;
  std::size_t pairs = 0;
  for (std::size_t c = 0; c < canvases.size(); ++c) {
    const TextureChart& chart = charts[c];
    const auto width = static_cast<std::size_t>(chart.colors.width);
    for (std::size_t texel = 0; texel < chart.kinds.size(); ++texel)
      for (const std::size_t next : {texel + 1, texel + width}) {
        if (next >= chart.kinds.size() || (next == texel + 1 && next % width == 0) ||
            chart.kinds[texel] != TexelKind::Seen ||
            chart.kinds[next] != TexelKind::Seen ||
            !isDeep(canvases[c], texel, from_rim))
          continue;
        const bool is_border = canvases[c].samples[texel].front().view !=
                               canvases[c].samples[next].front().view;
        (is_border ? steps.across : steps.inside) += step(chart, texel, next);
        ++(is_border ? steps.borders : pairs);
      }
  }
  steps.across /= static_cast<double>(std::max<std::size_t>(steps.borders, 1));
  steps.inside /= static_cast<double>(std::max<std::size_t>(pairs, 1));
  return steps;
}

constexpr std::uint64_t seed = 1;

std::vector<PlanePatch>
findPlanes()
{
  const SimulatedCloud& cloud = corridor().whole();
  const VotedMesh voted = meshAndVote(cloud);
  PlaneHypotheses hypotheses;
  hypotheses.points = voted.vertices();
  hypotheses.triangles = voted.mesh.triangles;
  addVotes(voted.votes, hypotheses);
  PlaneClusteringSettings settings;
  settings.noise_driven = true;
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
paint(const std::vector<double>& exposures)
{
  static const std::vector<PlanePatch> planes = findPlanes();
  const SimulatedScene& scene = corridor().scene();
  const Trajectory& trajectory = corridor().whole().merged.trajectory;
  constexpr double texel_size = 0.02;
  constexpr int fill_distance = 5;
  const TexturingSettings settings;
  Painted painted;
  std::size_t left_out = 0;
  painted.canvases = texturing::canvasesOf(
      planes, {}, texel_size, settings.maximum_texture_size, left_out);
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
          texturing::fillHoles(fill_distance, canvas.mask, chart);
        }
      }).cpu;
  painted.map.planes = planes;
  return painted;
}

/** Mean similarity of some views with renderings of the map from the same poses. */
double
redrawnSimilarity(const Painted& painted, const std::vector<double>& exposures)
{
  constexpr std::size_t step = 15;
  const SimulatedScene& scene = corridor().scene();
  std::vector<double> similarities;
  for (std::size_t v = 0; v < exposures.size(); v += step) {
    const SimulatedObservation seen =
        observeWith(scene, v, exposures[v] * painted.gains[v]);
    const MapView drawn = castMap(painted.map,
                                  {{scene.rig.focal_length,
                                    scene.rig.focal_length,
                                    scene.rig.center_x,
                                    scene.rig.center_y},
                                   scene.rig.width,
                                   scene.rig.height},
                                  corridor().whole().merged.trajectory.poses[v]);
    std::vector<std::uint8_t> rgb;
    for (const ObservationPixel& pixel : seen.pixels)
      for (const int shift : {16, 8, 0})
        rgb.push_back(static_cast<std::uint8_t>(pixel.rgb >> shift));
    similarities.push_back(structuralSimilarity(
        rgb, drawn.rgb, drawn.is_known, static_cast<std::size_t>(seen.width)));
  }
  return meanOf(similarities);
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
printViews(const std::string& name, const std::vector<double>& exposures)
{
  constexpr double min_similarity = 0.9, max_steps = 1.5;
  const Painted painted = paint(exposures);
  const SeamSteps all = measureSeams(painted.canvases, painted.map.charts, 0);
  const SeamSteps steps = measureSeams(painted.canvases, painted.map.charts, 5);
  std::size_t texels = 0;
  for (const TextureChart& chart : painted.map.charts)
    texels += chart.kinds.size();
  printHead("views | number | charts | texels | SSIM of views drawn again | 10 cm from "
            "rims: step across borders of views | inside | ratio | ratio everywhere | "
            "exposure left, % | CPU s");
  Row() << name << exposures.size() << painted.map.charts.size() << texels
        << atLeast(redrawnSimilarity(painted, exposures), min_similarity, 3)
        << figure(steps.across, 2) << figure(steps.inside, 2)
        << atMost(steps.across / steps.inside, max_steps, 2)
        << atMost(all.across / all.inside, max_steps, 2)
        << figure(100 * unbalanced(painted.gains, exposures), 2)
        << figure(painted.seconds, 1);
}

const Section views_section("views", [] {
  printViews("as they are", std::vector<double>(corridor().scene().views.size(), 1.0));
});

/** With views that are brighter and darker by up to a quarter. */
const Section exposure_section("exposure", [] {
  Random random(seed);
  std::vector<double> exposures;
  for (std::size_t v = 0; v < corridor().scene().views.size(); ++v)
    exposures.push_back(std::exp(random.uniform(-0.22, 0.22)));
  printViews("brighter and darker", exposures);
});

} // namespace
} // namespace pcl::acmap::bench
