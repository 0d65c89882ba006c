#include "cylinders/cylinder_growth.h"
#include "cylinders/cylinder_templates.h"
#include "cylinders/points_beside.h"

#include <pcl/core/impl/large_memory.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/noise_scale.h>
#include <pcl/segmentation/impl/cylinder_clustering_kernel.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap {
namespace cylinders {
namespace {

KnownFaces
facesOf(const GivenPlanes& planes, const SurfaceElements& elements)
{
  KnownFaces faces;
  for (const PlanePatch& patch : planes.patches) {
    Eigen::Vector4d face = patch.coefficients;
    face[3] += face.head<3>().dot(elements.origin);
    faces.planes.push_back(face);
  }
  faces.labels = planes.labels;
  return faces;
}

/** The covariance in the axes of a patch. */
Matrix5
turned(const CylinderFit& fit, const CylinderPatch& patch)
{
  Eigen::Matrix2d turn;
  turn << patch.axis_u.dot(fit.u), patch.axis_u.dot(fit.v), patch.axis_v.dot(fit.u),
      patch.axis_v.dot(fit.v);
  Matrix5 all = Matrix5::Identity();
  all.topLeftCorner<2, 2>() = turn;
  all.block<2, 2>(2, 2) = turn;
  return all * fit.covariance * all.transpose();
}

/** Describes a fitted cylinder in the frame of the hypotheses. */
CylinderPatch
patchOf(const CylinderFit& fit, const std::vector<Sample>& samples, double spacing)
{
  const Cylinder& cylinder = fit.cylinder;
  const Development development(cylinder);
  const CylinderReach reach = reachOf(cylinder, samples, spacing);
  CylinderPatch patch;
  patch.axis_point = cylinder.point;
  patch.axis_direction = cylinder.axis;
  patch.radius = cylinder.radius;
  patch.is_hollow = cylinder.is_hollow;
  const double middle = reach.arc_begin + reach.arc_length / 2;
  patch.axis_u = std::cos(middle) * development.u + std::sin(middle) * development.v;
  patch.axis_v = cylinder.axis.cross(patch.axis_u);
  patch.low = reach.low;
  patch.high = reach.high;
  patch.arc = reach.arc_length;
  patch.covariance = turned(fit, patch);
  patch.support = samples.size();
  patch.rms = fit.rms;
  patch.area = reach.arc * cylinder.radius * (reach.high - reach.low);
  return patch;
}

/** Counts and bits of the surface without its cylinders. */
void
describeBefore(const SurfaceElements& elements,
               const KnownFaces& faces,
               CylinderClusteringReport& report)
{
  const DescriptionLength lengths(elements.sigma, elements.spacing, elements.extent);
  std::vector<double> sizes(faces.planes.size(), 0);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::int32_t label = faces.labels.empty() ? -1 : faces.labels[i];
    if (!elements.points[i].allFinite())
      continue;
    if (label < 0) {
      report.bits_before += lengths.freeElement();
      continue;
    }
    const Eigen::Vector4d& face = faces.planes[static_cast<std::size_t>(label)];
    report.bits_before +=
        lengths.element(face.head<3>().dot(elements.points[i]) + face[3]);
    ++report.points_on_planes;
    sizes[static_cast<std::size_t>(label)] += 1;
  }
  for (const double size : sizes)
    report.bits_before += lengths.plane(size);
}

/** Points and the planes that were given for them; without noise if that cannot be
 * measured.
 * \param[in] labels plane of each point; empty: there are no planes
 * \param[in] known_scale of the points, if it was measured before */
RawCloud
rawCloudOf(const PointView& points,
           const SensorView& sensors,
           const std::vector<PlanePatch>& planes,
           PointLabels labels,
           const std::optional<NoiseScale>& known_scale,
           double sigma)
{
  RawCloud cloud{points, sensors, {}, {}, {}, 0, sigma};
  if (labels.empty())
    cloud.labels.assign(points.size(), -1);
  else {
    cloud.labels = std::move(labels);
    cloud.planes = planes;
    cloud.is_bent.assign(cloud.planes.size(), 0);
  }
  const NoiseScale scale =
      known_scale ? *known_scale : measureNoiseScale(points, sensors);
  cloud.spacing = scale.spacing;
  cloud.is_along_rays = isAlongRays(cloud);
  if (sigma > 0)
    return cloud;
  const double measured = noiseOnPlanes(cloud);
  cloud.sigma = measured > 0 ? measured : scale.sigma;
  return cloud;
}

/** Fits a cylinder again without the samples near planes that stay: which points these took
 * there depends on the noise, and would shift the fit. */
void
fitAwayFromPlanes(const RawCloud& source,
                  const std::set<std::int32_t>& beside,
                  RawCylinder& cylinder)
{
  constexpr double gate = 4, min_share = 0.75;
  std::vector<Eigen::Vector4d> planes;
  for (const std::int32_t plane : beside)
    planes.push_back(source.planes[static_cast<std::size_t>(plane)].coefficients);
  std::vector<Sample> samples;
  for (const Sample& sample : cylinder.samples) {
    // where the ray meets the cylinder: the measured points would be chosen by their noise
    const Eigen::Vector3d foot = Offset(cylinder.fit.cylinder, sample).foot;
    if (std::none_of(planes.begin(), planes.end(), [&](const Eigen::Vector4d& plane) {
          return std::abs(plane.head<3>().dot(foot) + plane[3]) < gate * source.sigma;
        }))
      samples.push_back(sample);
  }
  if (static_cast<double>(samples.size()) <
      min_share * static_cast<double>(cylinder.samples.size()))
    return;
  auto fit = fitCylinder(samples, cylinder.fit.cylinder, source.sigma);
  if (!fit)
    return;
  cylinder.fit = *fit;
  setCovariance(samples, source.sigma, 2 * source.spacing, cylinder.fit);
}

/** Fits a cylinder to the points of the source that are on no plane that stays.
 * \param[in] owners cylinder of each point of the source, -1 for none
 * \return false if it is none: where a mesh rounds the edge of two planes, the points are
 * on these planes; or rays pass through it */
bool
refitToSource(const RawCloud& source,
              const SourceBlocks& blocks,
              const PointLabels& owners,
              const GrownCylinder& grown,
              RawCylinder& cylinder)
{
  constexpr std::size_t min_points = 60;
  constexpr double min_share = 0.5;
  constexpr double max_rms = 1.6; // sigmas: bars and mouldings are not round
  const CylinderReach reach =
      reachOf(cylinder.fit.cylinder, cylinder.samples, 2 * source.spacing);
  const PointsBeside beside =
      blocks.beside(owners, grown.planes, cylinder.fit.cylinder, reach);
  const double radius = cylinder.fit.cylinder.radius;
  if (static_cast<double>(beside.free_on) <
          min_share * static_cast<double>(beside.on) ||
      !gatherRaw(source, beside.free, reach, cylinder) ||
      cylinder.members.size() < min_points ||
      cylinder.fit.rms > max_rms * source.sigma ||
      std::abs(cylinder.fit.cylinder.radius - radius) > max_radius_change * radius)
    return false;
  fitAwayFromPlanes(source, beside.planes, cylinder);
  return !isLookedThrough(
      source,
      cylinder,
      reachOf(cylinder.fit.cylinder, cylinder.samples, 2 * source.spacing));
}

/** Appends a cylinder with the labels of its members. */
void
append(CylinderPatch&& patch,
       const std::vector<std::int32_t>& members,
       PointLabels& labels,
       std::vector<CylinderPatch>& patches)
{
  for (const std::int32_t member : members)
    labels[static_cast<std::size_t>(member)] =
        static_cast<std::int32_t>(patches.size());
  patches.push_back(std::move(patch));
}

/** Elements on a cylinder that was found in the source; not those of others and of planes
 * that stay. */
std::vector<std::int32_t>
elementsOn(const CylinderPatch& patch,
           const SurfaceElements& elements,
           const KnownFaces& faces,
           const PointLabels& owners,
           double sigma)
{
  constexpr double gate = 4, max_gap = 0.25; // sigmas; of the spacing
  const double distance = std::max(gate * sigma, max_gap * elements.spacing);
  const Cylinder cylinder{patch.axis_point, patch.axis_direction, patch.radius, false};
  std::vector<std::int32_t> members;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Eigen::Vector3d place = elements.points[i] + elements.origin;
    const double along = cylinder.along(place);
    if (owners[i] >= 0 || !(std::abs(cylinder.distance(place)) < distance) ||
        along < patch.low - elements.spacing || along > patch.high + elements.spacing)
      continue;
    const std::int32_t plane = faces.labels.empty() ? -1 : faces.labels[i];
    const Eigen::Vector3d across = cylinder.across(place);
    const double turn = std::atan2(across.dot(patch.axis_v), across.dot(patch.axis_u));
    const bool is_free =
        plane < 0 || std::find(patch.planes.begin(), patch.planes.end(), plane) !=
                         patch.planes.end();
    if (is_free && std::abs(turn) < patch.arc / 2 + elements.spacing / patch.radius)
      members.push_back(static_cast<std::int32_t>(i));
  }
  return members;
}

/** Finds cylinders in the source that the mesh was too coarse or too rough for.
 * \param[in,out] raw in: the source with its planes; out: those that were replaced have no
 * points, and others are marked as bent
 * \param[in,out] found cylinders of the mesh, and behind them the missed ones */
void
searchMissed(const CylinderClusteringSettings& settings,
             const Progress& progress,
             RawCloud& raw,
             std::vector<RawCylinder>& found)
{
  constexpr double min_sagitta = 0.03; // of the width: no wall that is warped
  std::vector<std::uint8_t> is_replaced(raw.planes.size(), 0);
  for (const RawCylinder& cylinder : found)
    for (const std::int32_t plane : cylinder.planes)
      is_replaced[static_cast<std::size_t>(plane)] = 1;
  for (std::int32_t& label : raw.labels)
    if (label >= 0 && is_replaced[static_cast<std::size_t>(label)])
      label = -1;
  markBentPlanes(min_sagitta, raw);
  markThickPlanes(min_sagitta, raw);
  addMissedCylinders(raw, {settings.min_radius, settings.max_radius}, progress, found);
}

/** Finds cylinders over elements with normals, and fits them to the source. */
void
searchSurface(const PlaneHypotheses& hypotheses,
              const PlaneSource& source,
              const GivenPlanes& planes,
              const CylinderClusteringSettings& settings,
              const Progress& progress,
              CylinderClusters& clusters,
              CylinderClusteringReport& report)
{
  const bool has_source = source.points.size() > 0;
  const SurfaceElements elements(hypotheses, has_source ? 0 : settings.sigma);
  report.spacing = elements.spacing;
  report.sigma = elements.sigma;
  report.planes = planes.patches.size();
  if (!(elements.spacing > 0))
    return;
  const KnownFaces faces = facesOf(planes, elements);
  describeBefore(elements, faces, report);
  report.bits_after = report.bits_before;
  std::vector<GrownCylinder> candidates = growCylinders(
      elements, faces, {settings.min_radius, settings.max_radius}, progress);
  RawCloud raw;
  if (has_source)
    raw = rawCloudOf(source.points,
                     source.sensors,
                     planes.patches,
                     planes.source_labels,
                     settings.source_scale,
                     settings.sigma);
  const bool has_noise = raw.sigma > 0 && raw.spacing > 0;
  const SourceBlocks blocks(raw);
  std::vector<RawCylinder> found;
  std::vector<std::vector<std::int32_t>> members_of_mesh;
  for (GrownCylinder& grown : candidates) {
    RawCylinder cylinder{
        grown.fit, elements.samplesOf(grown.members), {}, grown.planes, grown.gain};
    setCovariance(cylinder.samples, elements.sigma, 2 * elements.spacing, cylinder.fit);
    cylinder.fit.cylinder.point += elements.origin;
    for (Sample& sample : cylinder.samples)
      sample.point += elements.origin;
    if (has_noise &&
        !refitToSource(raw, blocks, clusters.source_labels, grown, cylinder))
      continue;
    for (const std::int32_t member : cylinder.members)
      clusters.source_labels[static_cast<std::size_t>(member)] =
          static_cast<std::int32_t>(found.size());
    found.push_back(std::move(cylinder));
    members_of_mesh.push_back(std::move(grown.members));
  }
  if (has_noise && !raw.planes.empty())
    searchMissed(settings, progress, raw, found);
  std::fill(clusters.source_labels.begin(), clusters.source_labels.end(), -1);
  members_of_mesh.resize(found.size());
  for (std::size_t c = 0; c < found.size(); ++c) {
    const RawCylinder& cylinder = found[c];
    CylinderPatch patch =
        patchOf(cylinder.fit,
                cylinder.samples,
                cylinder.is_changed ? 2 * raw.spacing : elements.spacing);
    patch.planes = cylinder.planes;
    patch.saved_bits = cylinder.gain;
    report.replaced_planes += cylinder.planes.size();
    report.bits_after -= cylinder.gain;
    for (const std::int32_t member : cylinder.members)
      clusters.source_labels[static_cast<std::size_t>(member)] =
          static_cast<std::int32_t>(c);
    std::vector<std::int32_t>& members = members_of_mesh[c];
    if (cylinder.is_changed) {
      const std::vector<std::int32_t> more =
          elementsOn(patch, elements, faces, clusters.labels, raw.sigma);
      members.insert(members.end(), more.begin(), more.end());
    }
    append(std::move(patch), members, clusters.labels, clusters.patches);
  }
}

/** Finds planes, if none are given, and cylinders among the rest, in a cloud whose noise
 * hides the normals. */
void
searchRaw(const PlaneHypotheses& hypotheses,
          double local_noise,
          const GivenPlanes& planes,
          const CylinderClusteringSettings& settings,
          const Progress& progress,
          CylinderClusters& clusters,
          CylinderClusteringReport& report)
{
  const PointView& points = hypotheses.points;
  const SensorView& sensors = hypotheses.sensors;
  RawCloud cloud =
      planes.labels.empty()
          ? findRawPlanes(points, sensors, settings.sigma, settings.threads, progress)
          : rawCloudOf(
                points, sensors, planes.patches, planes.labels, {}, settings.sigma);
  if (!(cloud.sigma > 0))
    cloud.sigma = local_noise; // everything is too curved for planes
  report.spacing = cloud.spacing;
  report.sigma = cloud.sigma;
  report.planes = cloud.planes.size();
  if (!(cloud.spacing > 0))
    return;
  const DescriptionLength lengths = lengthsOf(cloud);
  std::vector<double> sizes(cloud.planes.size(), 0);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!cloud.points[i].allFinite())
      continue;
    report.bits_before += bitsOfPoint(cloud, lengths, i);
    if (cloud.labels[i] < 0)
      continue;
    ++report.points_on_planes;
    sizes[static_cast<std::size_t>(cloud.labels[i])] += 1;
  }
  for (const double size : sizes)
    report.bits_before += lengths.plane(size);
  report.bits_after = report.bits_before;
  for (const RawCylinder& cylinder :
       findRawCylinders(cloud, {settings.min_radius, settings.max_radius}, progress)) {
    CylinderPatch patch = patchOf(cylinder.fit, cylinder.samples, 2 * cloud.spacing);
    patch.saved_bits = cylinder.gain;
    report.replaced_planes += cylinder.planes.size();
    report.bits_after -= cylinder.gain;
    if (!planes.labels.empty())
      patch.planes = cylinder.planes;
    append(std::move(patch), cylinder.members, clusters.labels, clusters.patches);
  }
}

/** Is the source the cloud itself? */
bool
isSame(const PointView& points, const PointView& source)
{
  if (points.size() != source.size())
    return false;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i] != source[i] && points[i].allFinite())
      return false;
  return true;
}

/** Sets counts, and the reason if there are no cylinders. */
void
describe(const PlaneHypotheses& hypotheses,
         const CylinderClusters& clusters,
         CylinderClusteringReport& report)
{
  report.cylinders = clusters.patches.size();
  for (std::size_t i = 0; i < hypotheses.points.size(); ++i)
    report.invalid_points += hypotheses.points[i].allFinite() ? 0 : 1;
  for (const std::int32_t label : clusters.labels)
    report.points_on_cylinders += label >= 0 ? 1 : 0;
  if (report.cylinders > 0)
    return;
  if (!(report.spacing > 0))
    report.remarks.emplace_back("no cylinders: the points are on no surface");
  else
    report.remarks.emplace_back("no cylinders: planes and free points describe the "
                                "cloud in fewer bits, or nothing is curved enough");
}

/** Sorts by decreasing area and changes the labels accordingly. */
void
sortByArea(CylinderClusters& clusters)
{
  std::vector<std::int32_t> order(clusters.patches.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return clusters.patches[static_cast<std::size_t>(a)].area >
           clusters.patches[static_cast<std::size_t>(b)].area;
  });
  std::vector<std::int32_t> numbers(order.size());
  std::vector<CylinderPatch> sorted;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto from = static_cast<std::size_t>(order[i]);
    numbers[from] = static_cast<std::int32_t>(i);
    sorted.push_back(std::move(clusters.patches[from]));
  }
  clusters.patches = std::move(sorted);
  const auto renumber = [&](std::int32_t& label) {
    label = label < 0 ? -1 : numbers[static_cast<std::size_t>(label)];
  };
  std::for_each(clusters.labels.begin(), clusters.labels.end(), renumber);
  std::for_each(clusters.source_labels.begin(), clusters.source_labels.end(), renumber);
}

} // namespace
} // namespace cylinders

CylinderClusters
clusterCylinders(const PlaneHypotheses& hypotheses,
                 const PlaneSource& source,
                 const GivenPlanes& planes,
                 const CylinderClusteringSettings& settings,
                 const Progress& progress,
                 CylinderClusteringReport& report)
{
  using namespace cylinders;
  return withThreads(settings.threads, [&] {
    report = {};
    report.points = hypotheses.points.size();
    StepTimer timer(report);
    progress.tell(0.0, "surface");
    CylinderClusters clusters;
    clusters.labels.assign(hypotheses.points.size(), -1);
    assignLarge(clusters.source_labels, source.points.size(), std::int32_t{-1});
    constexpr double max_noise = 0.03; // of the spacing, for normals of quadrics
    LocalNoise noise;
    if (hypotheses.triangles.empty() && hypotheses.normals.empty())
      noise = measureLocalNoise(hypotheses.points);
    const bool is_raw = noise.sigma > max_noise * noise.spacing;
    if (is_raw)
      searchRaw(hypotheses, noise.sigma, planes, settings, progress, clusters, report);
    else
      searchSurface(hypotheses, source, planes, settings, progress, clusters, report);
    if (is_raw && isSame(hypotheses.points, source.points))
      clusters.source_labels.assign(clusters.labels.begin(), clusters.labels.end());
    timer.finish("cylinders");
    sortByArea(clusters);
    report.templates = shareRadii(clusters.patches);
    describe(hypotheses, clusters, report);
    progress.tell(1.0, "done");
    return clusters;
  });
}

} // namespace pcl::acmap
