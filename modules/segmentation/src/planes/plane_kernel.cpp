#include "labeling/label_points.h"
#include "outlines/patch_outlines.h"
#include "outlines/shared_outlines.h"
#include "planes/known_planes.h"
#include "planes/paper_growth.h"
#include "planes/plane_growth.h"
#include "planes/plane_merge.h"
#include "planes/plane_sides.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::acmap {
namespace planes {
namespace {

/** All hypotheses in order of increasing curvature; if noise-driven, those that are not
 * at creases. */
std::vector<std::int32_t>
orderSeeds(const PlaneHypotheses& hypotheses, bool noise_driven, const CellGraph& graph)
{
  const bool omits_creases = noise_driven && !hypotheses.is_crease.empty();
  std::vector<std::int32_t> seeds;
  for (std::size_t i = 0; i < graph.size(); ++i)
    if (graph.hasNormal(i) && (!omits_creases || !hypotheses.is_crease[i]))
      seeds.push_back(static_cast<std::int32_t>(i));
  const auto curvature = [&](std::int32_t seed) {
    const float known = hypotheses.curvatures[static_cast<std::size_t>(seed)];
    return std::isnan(known) ? std::numeric_limits<float>::infinity() : known;
  };
  if (!hypotheses.curvatures.empty())
    std::stable_sort(seeds.begin(), seeds.end(), [&](std::int32_t a, std::int32_t b) {
      return curvature(a) < curvature(b);
    });
  return seeds;
}

/** \param[in] largest metres, of what follows from the spacing */
double
automaticDistance(const CellGraph& graph,
                  double largest = std::numeric_limits<double>::infinity())
{
  constexpr double sigmas = 5, spacings = 0.1;
  return std::max(sigmas * graph.sigma, std::min(spacings * graph.spacing, largest));
}

/** A tenth of a square metre for buildings; for small scenes, such as the scan of a
 * desk, a small fraction of the total surface. */
double
automaticArea(const CellGraph& graph)
{
  constexpr double of_buildings = 0.1, share = 0.003;
  const double surface = std::accumulate(graph.areas.begin(), graph.areas.end(), 0.0);
  return std::min(of_buildings, share * surface);
}

/** Grows all regions within the noise and merges those of one plane. */
std::vector<GrownPlane>
growAll(const CellGraph& graph,
        const std::vector<std::int32_t>& seeds,
        const PlaneLimits& limits,
        double min_area,
        double merge_cosine,
        PlaneClusteringReport& report)
{
  std::vector<GrownPlane> grown =
      growNoiseDriven(graph, seeds, limits, min_area, report);
  report.merged = mergePlanes(grown, merge_cosine, limits.distance / 2);
  if (limits.bow > 0)
    report.merged += joinContinued(graph, limits, merge_cosine, grown);
  raiseStrips(graph, grown);
  const double noise = automaticDistance(graph); // a given W_t may be much larger
  widenRims(graph, std::min(limits.distance, noise), grown);
  return grown;
}

/** Converts the grown planes to the frame of the hypotheses. */
KnownPlanes
knownPlanes(const CellGraph& graph, const std::vector<GrownPlane>& grown)
{
  KnownPlanes known;
  known.spacing = graph.spacing;
  known.labels.assign(graph.size(), -1);
  for (std::size_t p = 0; p < grown.size(); ++p) {
    const Plane& plane = grown[p].plane;
    PlanePatch patch;
    patch.coefficients << plane.normal, plane.offset - plane.normal.dot(graph.origin);
    // The mean of members on a line, to which no plane was fitted, may be off the
    // plane.
    const Eigen::Vector3d middle = grown[p].moments.mean();
    patch.center = middle - plane.distance(middle) * plane.normal + graph.origin;
    patch.axis_u = plane.normal.unitOrthogonal();
    patch.axis_v = plane.normal.cross(patch.axis_u);
    patch.support = grown[p].members.size();
    patch.area = grown[p].area;
    known.planes.push_back({patch, grown[p].trust, grown[p].warp});
    for (const std::int32_t member : grown[p].members)
      known.labels[static_cast<std::size_t>(member)] = static_cast<std::int32_t>(p);
  }
  return known;
}

/** Removes small regions and strips, which cannot be verified without a source. */
void
dropUnsure(KnownPlanes& known, PlaneClusteringReport& report)
{
  std::vector<std::int32_t> numbers;
  std::vector<KnownPlane> sure;
  for (KnownPlane& plane : known.planes) {
    const bool is_sure = plane.trust == PlaneTrust::Sure;
    numbers.push_back(is_sure ? static_cast<std::int32_t>(sure.size()) : -1);
    if (is_sure)
      sure.push_back(std::move(plane));
  }
  report.small_regions += known.planes.size() - sure.size();
  known.planes = std::move(sure);
  for (std::int32_t& label : known.labels)
    label = label < 0 ? -1 : numbers[static_cast<std::size_t>(label)];
}

/** Counts patches that look like layers of a quantised depth: they are parallel to
 * other such patches and have far fewer points than their area requires. */
std::size_t
countLayers(const std::vector<PlanePatch>& patches, double spacing)
{
  constexpr double min_filling = 0.25;
  const double parallel = std::cos(0.0175);
  std::vector<Eigen::Vector3d> normals;
  for (const PlanePatch& patch : patches)
    if (static_cast<double>(patch.support) * spacing * spacing <
        min_filling * patch.area)
      normals.push_back(patch.coefficients.head<3>());
  constexpr std::ptrdiff_t fewest = 3;
  return static_cast<std::size_t>(
      std::count_if(normals.begin(), normals.end(), [&](const Eigen::Vector3d& normal) {
        return std::count_if(
                   normals.begin(), normals.end(), [&](const Eigen::Vector3d& other) {
                     return std::abs(normal.dot(other)) > parallel;
                   }) >= fewest;
      }));
}

/** Sets counts and remarks, with the reason if no planes were found. */
void
describe(const PlaneClusters& clusters,
         const PlaneHypotheses& hypotheses,
         PlaneClusteringReport& report)
{
  report.planes = clusters.patches.size();
  for (std::size_t i = 0; i < hypotheses.points.size(); ++i)
    report.invalid_points += hypotheses.points[i].allFinite() ? 0 : 1;
  for (const std::int32_t label : clusters.labels)
    report.points_on_planes += label >= 0 ? 1 : 0;
  if (hypotheses.triangles.empty())
    report.remarks.emplace_back("without a mesh the planes have no outlines");
  else if (const auto bare = std::count_if(
               clusters.patches.begin(),
               clusters.patches.end(),
               [](const PlanePatch& patch) { return patch.polygons.empty(); });
           bare > 0)
    report.remarks.push_back(
        std::to_string(bare) +
        " planes have no outline: their points are on lines, and no "
        "surface is seen between these");
  if (const std::size_t layers = countLayers(clusters.patches, report.spacing))
    report.remarks.push_back(
        std::to_string(layers) + " of the " + std::to_string(report.planes) +
        " planes look like layers of a quantised depth: they are parallel and have "
        "less "
        "than a quarter of the points that their area asks for; segment the organized "
        "view (DepthPlaneSegmentation), or consolidate the cloud");
  if (report.planes_through_sensor > 0)
    report.remarks.push_back(
        std::to_string(report.planes_through_sensor) +
        " planes pass through the sensor: they are rings or sheets "
        "of its rays, no surfaces, and were removed");
  if (100 * report.points_on_curved > report.points)
    report.remarks.push_back(std::to_string(report.points_on_curved) +
                             " points lie on curved surfaces, which are no planes");
  if (report.planes > 0)
    return;
  if (report.hypotheses == 0)
    report.remarks.emplace_back("no planes: no point off creases has a normal");
  else if (report.tested_hypotheses > 0)
    report.remarks.push_back("no planes: none of " +
                             std::to_string(report.tested_hypotheses) +
                             " hypotheses has enough supporters");
  else if (report.refuted_regions > 0)
    report.remarks.push_back("no planes: the source's points lie on none of " +
                             std::to_string(report.refuted_regions) + " regions");
  else if (!(report.spacing > 0))
    report.remarks.emplace_back("no planes: the points are on no surface");
  else
    report.remarks.push_back(
        "no planes: " + std::to_string(report.small_regions) +
        " regions are too small or narrow, " + std::to_string(report.curved_regions) +
        " are curved; the points may be too far apart, too noisy, or on no plane");
}

/** Limits of growing. Bending and warping of planes is permitted if noise-driven and no
 * plane distance is set. */
PlaneLimits
growthLimits(const PlaneClusteringSettings& settings, const CellGraph& graph)
{
  PlaneLimits limits;
  constexpr double largest = 0.1; // metres: sparse points are as precise as others
  const double automatic =
      settings.noise_driven ? automaticDistance(graph, largest) : paper_plane_distance;
  limits.distance = settings.plane_distance.value_or(automatic);
  limits.cosine = std::cos(settings.normal_angle);
  if (settings.noise_driven && !settings.plane_distance) {
    limits.bow = 0.004;
    limits.max_bow = 0.01;
    limits.max_warp = 0.025;
  }
  return limits;
}

/** Moves labels and patches to the result, without intermediate data. */
void
takeOver(KnownPlanes&& known, PlaneClusters& clusters)
{
  clusters.labels = std::move(known.labels);
  for (KnownPlane& plane : known.planes)
    clusters.patches.push_back(std::move(plane.patch));
  sortByArea(clusters);
}

} // namespace
} // namespace planes

PlaneClusters
clusterPlanes(const PlaneHypotheses& hypotheses,
              const PlaneSource& source,
              const PlaneClusteringSettings& settings,
              const Progress& progress,
              PlaneClusteringReport& report)
{
  using namespace planes;
  return withThreads(settings.threads, [&] {
    report = {};
    report.points = hypotheses.points.size();
    StepTimer timer(report);
    progress.tell(0.0, "growing");
    const bool is_consolidated = source.points.size() > hypotheses.points.size();
    const CellGraph graph(hypotheses, is_consolidated, settings.threads);
    const PlaneLimits limits = growthLimits(settings, graph);
    report.spacing = graph.spacing;
    report.sigma = graph.sigma;
    report.plane_distance = limits.distance;
    const std::vector<std::int32_t> seeds =
        orderSeeds(hypotheses, settings.noise_driven, graph);
    report.hypotheses = seeds.size();
    timer.finish("cells");

    const double min_area = settings.min_area > 0
                                ? settings.min_area
                                : std::max(automaticArea(graph), graph.least_area);
    const double merge_cosine = std::cos(settings.normal_angle / 2);
    std::vector<GrownPlane> grown;
    if (settings.noise_driven && graph.spacing > 0)
      grown = growAll(graph, seeds, limits, min_area, merge_cosine, report);
    else if (!settings.noise_driven)
      grown = growAsPaper(graph,
                          seeds,
                          {settings.member_distance,
                           settings.reach,
                           limits.cosine,
                           limits.distance,
                           settings.min_support},
                          progress,
                          report);
    timer.finish("growing");

    KnownPlanes known = knownPlanes(graph, grown);
    known.points = hypotheses.points;
    const double deviation =
        0.3 * std::max(limits.distance, automaticDistance(graph, limits.distance));
    known.max_warp = std::max(limits.max_warp, deviation);
    if (!is_consolidated) // else the hypotheses do not show the noise of the source
      known.max_sigma = deviation;
    PlaneClusters clusters;
    LabelingLimits labeling;
    labeling.distance = limits.distance / 2;
    labeling.cosine = merge_cosine;
    labeling.min_area = min_area;
    labeling.stray = std::max(automaticDistance(graph), 0.25 * graph.spacing);
    if (!settings.noise_driven)
      for (std::size_t p = 0; p < grown.size(); ++p)
        describeFit(graph, grown[p], known.planes[p]);
    else if (source.points.size() > 0) {
      clusters.source_labels =
          labelPoints(source.points, source.sensors, labeling, progress, known, report);
      PlaneSides sides;
      if (source.has_known_sensors)
        sides =
            turnToSensors(source.points, source.sensors, clusters.source_labels, known);
      report.turned_planes = sides.turned;
      report.planes_through_sensor = sides.removed;
    }
    else {
      dropUnsure(known, report);
      labeling.coarseness = 3; // windows of neighbouring consolidated points overlap
      fitLabeled(known.points, SensorView(), labeling, known);
    }
    if (settings.regular) {
      const Regularity regularity = makeRegular(known.planes);
      report.regular_planes = regularity.turned;
      report.largest_turn = regularity.largest_turn;
    }
    progress.tell(0.9, "outlines");
    StepTimer outlines(report);
    if (settings.noise_driven)
      report.contour_outlines =
          outlineFromEvidence(hypotheses.triangles,
                              hypotheses.sensors,
                              {source.points, source.sensors, clusters.source_labels},
                              known);
    else
      outlineFromMesh(hypotheses.triangles, known);
    outlines.finish("outlines");
    takeOver(std::move(known), clusters);
    describe(clusters, hypotheses, report);
    progress.tell(1.0, "done");
    return clusters;
  });
}

} // namespace pcl::acmap
