#include "cylinders/cylinder_growth.h"
#include "cylinders/raw_cylinders.h"

#include <pcl/core/impl/parallel.h>
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

std::vector<Sample>
samplesOf(const SurfaceElements& elements, const std::vector<std::int32_t>& members)
{
  std::vector<Sample> samples;
  for (const std::int32_t member : members)
    samples.push_back({elements.points[static_cast<std::size_t>(member)]});
  return samples;
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
patchOf(const CylinderFit& fit,
        const std::vector<Sample>& samples,
        double spacing,
        const Eigen::Vector3d& origin)
{
  const Cylinder& cylinder = fit.cylinder;
  const Development development(cylinder);
  const CylinderReach reach = reachOf(cylinder, samples, spacing);
  CylinderPatch patch;
  patch.axis_point = cylinder.point + origin;
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

/** Finds cylinders over elements with normals. */
void
searchSurface(const SurfaceElements& elements,
              const GivenPlanes& planes,
              const CylinderLimits& limits,
              const Progress& progress,
              CylinderClusters& clusters,
              CylinderClusteringReport& report)
{
  const KnownFaces faces = facesOf(planes, elements);
  for (GrownCylinder& cylinder : growCylinders(elements, faces, limits, progress)) {
    const std::vector<Sample> samples = samplesOf(elements, cylinder.members);
    setCovariance(samples, elements.sigma, 2 * elements.spacing, cylinder.fit);
    for (const std::int32_t member : cylinder.members)
      clusters.labels[static_cast<std::size_t>(member)] =
          static_cast<std::int32_t>(clusters.patches.size());
    clusters.patches.push_back(
        patchOf(cylinder.fit, samples, elements.spacing, elements.origin));
    clusters.patches.back().planes = cylinder.planes;
  }
  report.planes = planes.patches.size();
}

/** Finds planes, and cylinders among the rest, in a cloud whose noise hides the
 * normals. */
void
searchRaw(const PlaneHypotheses& hypotheses,
          const CylinderLimits& limits,
          const CylinderClusteringSettings& settings,
          const Progress& progress,
          CylinderClusters& clusters,
          CylinderClusteringReport& report)
{
  const RawCloud cloud = findRawPlanes(hypotheses.points,
                                       hypotheses.sensors,
                                       settings.sigma,
                                       settings.threads,
                                       progress);
  report.spacing = cloud.spacing;
  report.sigma = cloud.sigma;
  report.planes = cloud.planes.size();
  if (!(cloud.spacing > 0) || !(cloud.sigma > 0))
    return;
  for (const RawCylinder& cylinder : findRawCylinders(cloud, limits, progress)) {
    for (const std::int32_t member : cylinder.members)
      clusters.labels[static_cast<std::size_t>(member)] =
          static_cast<std::int32_t>(clusters.patches.size());
    clusters.patches.push_back(patchOf(
        cylinder.fit, cylinder.samples, 2 * cloud.spacing, Eigen::Vector3d::Zero()));
    clusters.patches.back().planes = cylinder.planes;
  }
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
  for (std::vector<std::int32_t>* labels : {&clusters.labels, &clusters.source_labels})
    for (std::int32_t& label : *labels)
      label = label < 0 ? -1 : numbers[static_cast<std::size_t>(label)];
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
    const SurfaceElements elements(hypotheses, settings.sigma);
    report.spacing = elements.spacing;
    report.sigma = elements.sigma;
    timer.finish("surface");
    CylinderClusters clusters;
    clusters.labels.assign(elements.size(), -1);
    clusters.source_labels.assign(source.points.size(), -1);
    const CylinderLimits limits{settings.min_radius, settings.max_radius};
    constexpr double max_noise = 0.1; // of the spacing, for normals of quadrics
    const bool is_raw = !elements.is_mesh && !elements.is_oriented &&
                        elements.sigma > max_noise * elements.spacing;
    if (is_raw)
      searchRaw(hypotheses, limits, settings, progress, clusters, report);
    else if (elements.spacing > 0)
      searchSurface(elements, planes, limits, progress, clusters, report);
    timer.finish("cylinders");
    sortByArea(clusters);
    report.cylinders = clusters.patches.size();
    progress.tell(1.0, "done");
    return clusters;
  });
}

} // namespace pcl::acmap
