#include "fuzzed_mesh.h"

#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

constexpr std::size_t max_points = 64;

/** Points with normals, a source cloud, and the settings of the clustering. */
struct ClusteringTask {
  PointStyle style;
  FuzzedMesh mesh;
  PlaneHypotheses hypotheses;
  std::vector<std::int32_t> views;
  PlaneSource source;
  PlaneClusteringSettings settings;

  explicit ClusteringTask(FuzzedBytes bytes)
  : style(bytes)
  , mesh(bytes, style, max_points)
  {
    const std::uint8_t choice = bytes.byte(), more = bytes.byte();
    const std::size_t size = mesh.points.size();
    hypotheses.points = viewOf(mesh.points);
    if (choice & 1)
      hypotheses.triangles = mesh.triangles;
    // Few directions, so that neighbouring normals agree.
    const bool has_one = choice & 2;
    const Eigen::Vector3f one = fuzzedNormal(bytes);
    while (hypotheses.normals.size() < size)
      hypotheses.normals.push_back(has_one ? one : fuzzedNormal(bytes));
    while (choice & 4 && hypotheses.is_crease.size() < size)
      hypotheses.is_crease.push_back(bytes.byte() & 1);
    while (choice & 8 && hypotheses.curvatures.size() < size)
      hypotheses.curvatures.push_back(style.coordinate(bytes));
    settings.noise_driven = choice & 16;
    if (choice & 32)
      source = {viewOf(mesh.points), fuzzedSensors(bytes, style, size, views)};
    settings.regular = choice & 64;
    settings.threads = choice & 128 && more >= 0xc0 ? 2 : 1;
    const auto length = [&](int steps) {
      return std::clamp(static_cast<double>(style.scale) * steps, 1e-9, 1e9);
    };
    settings.min_support = more & 7;
    if (!(settings.noise_driven && more & 8))
      settings.plane_distance = length(1 + bytes.byte()) / 16;
    settings.member_distance = length(1 + (bytes.byte() & 15));
    settings.normal_angle = (1 + bytes.byte()) / 256.0 * M_PI / 2;
    settings.min_area = more & 16 ? length(1 + bytes.byte()) : 0;
  }
};

PlaneClusters
cluster(const ClusteringTask& task, unsigned threads, PlaneClusteringReport& report)
{
  PlaneClusteringSettings settings = task.settings;
  settings.threads = threads;
  return clusterPlanes(task.hypotheses, task.source, settings, Progress(), report);
}

/** Maximum coordinate of the points. The sums are relative to their centre, so that
 * points far away are less accurate. */
double
largestCoordinate(const ClusteringTask& task)
{
  double largest = 0;
  for (const Eigen::Vector3f& point : task.mesh.points)
    if (point.allFinite())
      largest = std::max(largest, double{point.cwiseAbs().maxCoeff()});
  return largest;
}

/** Unit normal, right-handed axes, centre on the plane. */
void
requireFrame(const ClusteringTask& task, const PlanePatch& patch)
{
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  require(patch.coefficients.allFinite() && patch.center.allFinite());
  Eigen::Matrix3d axes;
  axes << patch.axis_u, patch.axis_v, normal;
  require((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm() < 1e-6);
  require(axes.determinant() > 0);
  const double far = patch.center.norm() + largestCoordinate(task);
  require(std::abs(normal.dot(patch.center) + patch.coefficients[3]) <= 1e-9 * far);
}

/** NaN, or a valid covariance, normalized by its own standard deviations, or by the
 * smallest number whose square is representable. */
void
requireCovariance(const Eigen::Matrix3d& covariance)
{
  if (covariance.array().isNaN().any())
    return;
  require(covariance.allFinite());
  const Eigen::Vector3d deviations =
      covariance.diagonal().cwiseMax(0.0).cwiseSqrt().cwiseMax(1e-145);
  require(covariance.diagonal().minCoeff() >= 0);
  const Eigen::Matrix3d scaled = deviations.cwiseInverse().asDiagonal() * covariance *
                                 deviations.cwiseInverse().asDiagonal();
  require((scaled - scaled.transpose()).norm() < 1e-6);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scaled);
  require(solver.eigenvalues()[0] >= -1e-6);
}

double
areaOf(const PlanePatch& patch, const std::vector<Eigen::Vector3f>& loop)
{
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  const Eigen::Vector3d first = loop.front().cast<double>();
  double twice = 0;
  for (std::size_t i = 0; i + 1 < loop.size(); ++i)
    twice += (loop[i].cast<double>() - first)
                 .cross(loop[i + 1].cast<double>() - first)
                 .dot(normal);
  return twice / 2;
}

/** Outlines are counter-clockwise, holes clockwise, and the area is that of the
 * polygons, within float accuracy. */
void
requirePolygons(const ClusteringTask& task, const PlanePatch& patch)
{
  require(std::isfinite(patch.area) && patch.area >= 0);
  require(!task.hypotheses.triangles.empty() || patch.polygons.empty());
  require(!patch.polygons.empty() || patch.area == 0);
  const bool is_exact = task.style.isModerate() && task.style.far == 0;
  double area = 0;
  for (const PlanePolygon& polygon : patch.polygons) {
    require(polygon.outer.size() >= 3);
    const double outer = areaOf(patch, polygon.outer);
    require(!is_exact || outer > 0);
    area += outer;
    for (const std::vector<Eigen::Vector3f>& hole : polygon.holes) {
      require(hole.size() >= 3);
      const double inner = areaOf(patch, hole);
      require(!is_exact || inner < 0);
      area += inner;
    }
  }
  if (is_exact)
    require(std::abs(patch.area - area) <=
            1e-3 * patch.area + 1e-6 * task.style.scale * task.style.scale);
}

void
requireSound(const ClusteringTask& task, const PlanePatch& patch)
{
  requireFrame(task, patch);
  requireCovariance(patch.covariance);
  require(patch.support <= task.mesh.points.size());
  require(std::isnan(patch.effective_support)
              ? patch.covariance.array().isNaN().any()
              : patch.effective_support >= 0 &&
                    patch.effective_support <= static_cast<double>(patch.support));
  require(std::isfinite(patch.rms) && patch.rms >= 0);
  requirePolygons(task, patch);
}

template <typename Labels>
void
requireLabels(const ClusteringTask& task, const Labels& labels, std::size_t patches)
{
  require(labels.size() == task.mesh.points.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    require(labels[i] >= -1 && labels[i] < static_cast<std::int32_t>(patches));
    require(labels[i] < 0 || task.mesh.points[i].allFinite());
  }
}

/** The supporters of the paper's planes are within W_d of the hypothesis, and so is their
 * mean, through which the plane goes. None is removed when the plane moves, so that W_t
 * is no bound. */
void
requireOnPlanes(const ClusteringTask& task, const PlaneClusters& found)
{
  if (task.settings.noise_driven || !task.style.isModerate())
    return;
  const double maximum = 2 * task.settings.member_distance;
  for (std::size_t i = 0; i < found.labels.size(); ++i) {
    if (found.labels[i] < 0)
      continue;
    const Eigen::Vector4d& plane = found.patches[found.labels[i]].coefficients;
    const Eigen::Vector3d point = task.mesh.points[i].cast<double>();
    require(std::abs(plane.head<3>().dot(point) + plane[3]) <= maximum);
  }
}

void
requireTrueReport(const ClusteringTask& task,
                  const PlaneClusters& found,
                  const PlaneClusteringReport& report)
{
  const auto count = std::count_if(found.labels.begin(),
                                   found.labels.end(),
                                   [](std::int32_t label) { return label >= 0; });
  require(report.points == task.mesh.points.size());
  require(report.planes == found.patches.size());
  require(report.points_on_planes == static_cast<std::size_t>(count));
  require(report.planes > 0 || !report.remarks.empty());
  require(std::is_sorted(found.patches.begin(),
                         found.patches.end(),
                         [](const auto& a, const auto& b) { return a.area > b.area; }));
}

/** A second run gives the same bytes, for any number of threads. */
void
requireSame(const PlaneClusters& a, const PlaneClusters& b)
{
  require(a.labels == b.labels && a.source_labels == b.source_labels &&
          a.patches.size() == b.patches.size());
  for (std::size_t p = 0; p < a.patches.size(); ++p) {
    const PlanePatch &one = a.patches[p], &other = b.patches[p];
    require(one.coefficients == other.coefficients && one.center == other.center &&
            one.area == other.area && one.support == other.support);
    require(std::memcmp(one.covariance.data(),
                        other.covariance.data(),
                        sizeof one.covariance) == 0);
    require(std::equal(one.polygons.begin(),
                       one.polygons.end(),
                       other.polygons.begin(),
                       other.polygons.end(),
                       [](const PlanePolygon& x, const PlanePolygon& y) {
                         return x.outer == y.outer && x.holes == y.holes;
                       }));
  }
}

void
clusterFuzzed(const ClusteringTask& task)
{
  PlaneClusteringReport report, again;
  const PlaneClusters found = cluster(task, task.settings.threads, report);
  requireLabels(task, found.labels, found.patches.size());
  if (task.settings.noise_driven && task.source.points.size() > 0)
    requireLabels(task, found.source_labels, found.patches.size());
  else
    require(found.source_labels.empty());
  for (const PlanePatch& patch : found.patches)
    requireSound(task, patch);
  requireOnPlanes(task, found);
  requireTrueReport(task, found, report);
  requireSame(found, cluster(task, 1, again));
}

} // namespace
} // namespace pcl::acmap::test

/** Any points give planes with the guarantees of PlaneHypothesisClustering. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace pcl::acmap::test;
  clusterFuzzed(ClusteringTask(FuzzedBytes(data, size)));
  return 0;
}
