#include "cylinders/raw_cylinders.h"

#include "large_median.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/voxel_windows.h>
#include <pcl/core/noise_scale.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::cylinders {
namespace {

/** One point and normal for each cell of a cloud. */
struct CellCloud {
  std::vector<Eigen::Vector3f> points;
  LargeVector<Eigen::Vector3f> normals; ///< towards the sensors; NaN where not planar
};

CellCloud
cellsOf(const VoxelMoments& voxels)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const VoxelWindows windows(voxels);
  VoxelWindows::Cursor cursor(windows, 1);
  const double edge = voxels.lattice.edge();
  CellCloud cells;
  for (std::size_t voxel = 0; voxel < windows.size(); ++voxel) {
    const std::vector<WindowPart>& parts = cursor.moveTo(voxel);
    Eigen::Vector3f way = Eigen::Vector3f::Zero();
    for (std::size_t c = windows.firstCell(voxel); c < windows.firstCell(voxel + 1);
         ++c)
      way += voxels.cells[c].way;
    const Moments own =
        sumParts(voxels, parts, [](const WindowPart& part) { return part.isMiddle(); });
    const PlaneFit plane =
        fitPlane(sumParts(voxels, parts, [](const WindowPart&) { return true; }));
    const VoxelCell& cell = voxels.cells[windows.firstCell(voxel)];
    cells.points.emplace_back(
        (voxels.lattice.center(placeOf(cell.key)) + edge * own.mean()).cast<float>());
    const Eigen::Vector3f normal = plane.normal.cast<float>();
    if (!plane.isPlanar())
      cells.normals.emplace_back(nan, nan, nan);
    else
      cells.normals.push_back(normal.dot(way) < 0 ? Eigen::Vector3f(-normal) : normal);
  }
  return cells;
}

/** Does the surface of a plane's points bend by more than their noise? The height of a
 * parabola is fitted to their offsets along both axes.
 * \param[in] min_sagitta of the width */
bool
isBent(const RawCloud& cloud,
       const PlanePatch& patch,
       const std::vector<std::int32_t>& members,
       double min_sagitta)
{
  using Terms = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  constexpr std::size_t min_points = 60;
  if (members.size() < min_points)
    return false;
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  Matrix matrix = Matrix::Zero();
  Terms right = Terms::Zero();
  Eigen::Vector2d spread = Eigen::Vector2d::Zero();
  double squares = 0, count = 0;
  for (const Sample& sample : samplesOf(cloud, members)) {
    const double slant = sample.hasRay() ? std::abs(sample.ray.dot(normal)) : 1;
    if (slant < min_slant)
      continue;
    double off = normal.dot(sample.point) + patch.coefficients[3];
    Eigen::Vector3d foot = sample.point - off * normal;
    if (sample.hasRay())
      foot = sample.point - off / sample.ray.dot(normal) * sample.ray;
    off /= slant; // all have the same noise along their rays
    const double a = (foot - patch.center).dot(patch.axis_u);
    const double b = (foot - patch.center).dot(patch.axis_v);
    Terms terms;
    terms << 1, a, b, a * a, a * b, b * b;
    terms /= slant;
    matrix += terms * terms.transpose();
    right += off * terms;
    squares += off * off;
    spread += Eigen::Vector2d(a * a, b * b);
    count += 1;
  }
  if (count < min_points)
    return false;
  const Eigen::LDLT<Matrix> solver(matrix);
  const Terms fit = solver.solve(right);
  const double variance = std::max(squares - fit.dot(right), 0.0) / (count - 6);
  const Matrix covariance = variance * solver.solve(Matrix(Matrix::Identity()));
  constexpr double deviations = 5;
  for (const int axis : {0, 1}) {
    const int term = axis == 0 ? 3 : 5;
    const double width = std::sqrt(12 * spread[axis] / count);
    const double sagitta = std::abs(fit[term]) * width * width / 4;
    if (std::abs(fit[term]) > deviations * std::sqrt(covariance(term, term)) &&
        sagitta > min_sagitta * width)
      return true;
  }
  return false;
}

} // namespace

void
markBentPlanes(double min_sagitta, RawCloud& cloud)
{
  std::vector<std::vector<std::int32_t>> members(cloud.planes.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (cloud.labels[i] >= 0)
      members[static_cast<std::size_t>(cloud.labels[i])].push_back(
          static_cast<std::int32_t>(i));
  constexpr std::size_t enough = 20000;
  cloud.is_bent.clear();
  for (std::size_t p = 0; p < members.size(); ++p)
    cloud.is_bent.push_back(
        isBent(cloud, cloud.planes[p], thinned(members[p], enough), min_sagitta) ? 1
                                                                                 : 0);
}

void
markThickPlanes(double min_sagitta, RawCloud& cloud)
{
  constexpr double of_parabola = 0.298; // rms over the sagitta
  constexpr double deviations = 5, min_ratio = 1.1;
  struct Sums {
    Moments moments;
    double squares = 0; ///< of distances from the plane
  };
  std::vector<Sums> sums(cloud.planes.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (cloud.labels[i] < 0)
      continue;
    const auto p = static_cast<std::size_t>(cloud.labels[i]);
    const PlanePatch& patch = cloud.planes[p];
    const Eigen::Vector3d from = cloud.points[i].cast<double>() - patch.center;
    sums[p].moments += momentsOf(from);
    sums[p].squares += std::pow(patch.coefficients.head<3>().dot(from), 2);
  }
  for (std::size_t p = 0; p < sums.size(); ++p) {
    const double count = sums[p].moments.count;
    if (count < 1)
      continue;
    const double ratio = std::sqrt(sums[p].squares / count) / cloud.sigma;
    const double excess = cloud.sigma * std::sqrt(std::max(ratio * ratio - 1, 0.0));
    const double width = std::sqrt(12 * fitPlane(sums[p].moments).variances[1]);
    if (ratio > std::max(min_ratio, 1 + deviations / std::sqrt(2 * count)) &&
        excess > of_parabola * min_sagitta * width)
      cloud.is_bent[p] = 1;
  }
}

bool
isAlongRays(const RawCloud& cloud)
{
  // log |offset| = terms of the range + slope * log cosine: the slope is 1 for noise along
  // the rays and 0 across the planes. The range has to be among the terms, because noise
  // grows with it, and points of one plane that are far away are seen at a flat angle.
  using Terms = Eigen::Vector4d;
  constexpr double min_cosine = 0.2, least = 1e-2; // of the spacing
  constexpr double of_logarithm = 1.234; // variance of the logarithm of |normal value|
  constexpr double max_deviation = 0.1, max_slope = 0.5;
  constexpr std::size_t enough = 200000;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Terms right = Terms::Zero();
  const std::size_t step = 1 + cloud.points.size() / enough;
  for (std::size_t i = 0; i < cloud.points.size(); i += step) {
    const std::int32_t label = cloud.labels[i];
    const Eigen::Vector3f* const sensor = cloud.sensors[i];
    if (label < 0 || !sensor || cloud.is_bent[static_cast<std::size_t>(label)])
      continue;
    const Eigen::Vector4d& plane =
        cloud.planes[static_cast<std::size_t>(label)].coefficients;
    const Eigen::Vector3d point = cloud.points[i].cast<double>();
    const Eigen::Vector3d way = point - sensor->cast<double>();
    const double range = way.norm();
    const double cosine = std::abs(plane.head<3>().dot(way)) / range;
    const double off = std::abs(plane.head<3>().dot(point) + plane[3]);
    if (!(cosine > min_cosine))
      continue;
    const double far = std::log(range / cloud.spacing);
    const Terms terms(1, far, far * far, std::log(cosine));
    matrix += terms * terms.transpose();
    right += std::log(std::max(off / cloud.spacing, least)) * terms;
  }
  const Eigen::LDLT<Eigen::Matrix4d> solver(matrix);
  const double variance = of_logarithm * solver.solve(Terms(Terms::Unit(3)))[3];
  const double slope = solver.solve(right)[3];
  return !(variance > 0 && variance < max_deviation * max_deviation &&
           slope < max_slope);
}

double
noiseOnPlanes(const RawCloud& cloud)
{
  constexpr double min_cosine = 0.3, none = std::numeric_limits<double>::quiet_NaN();
  const LargeMedian median = largeMedianOf(cloud.points.size(), [&](std::size_t i) {
    const std::int32_t label = cloud.labels[i];
    if (label < 0 || cloud.is_bent[static_cast<std::size_t>(label)])
      return none;
    const Eigen::Vector4d& plane =
        cloud.planes[static_cast<std::size_t>(label)].coefficients;
    const Eigen::Vector3f point = cloud.points[i];
    const Eigen::Vector3f* const sensor = cloud.sensors[i];
    const double off = plane.head<3>().dot(point.cast<double>()) + plane[3];
    double cosine = 1;
    if (sensor && cloud.is_along_rays)
      cosine =
          std::abs(plane.head<3>().dot((point - *sensor).cast<double>().normalized()));
    return cosine > min_cosine ? std::abs(off) / cosine : none;
  });
  constexpr std::size_t min_points = 100;
  constexpr double median_of_normal = 0.6745;
  return median.count < min_points ? 0 : median.value / median_of_normal;
}

Sample
sampleOf(const RawCloud& cloud, std::size_t i)
{
  Sample sample{cloud.points[i].cast<double>()};
  const Eigen::Vector3f* const sensor =
      cloud.is_along_rays ? cloud.sensors[i] : nullptr;
  if (sensor)
    sample.ray = (sample.point - sensor->cast<double>()).stableNormalized();
  return sample;
}

std::vector<Sample>
samplesOf(const RawCloud& cloud, const std::vector<std::int32_t>& members)
{
  std::vector<Sample> samples(members.size());
  parallelForChunks(members.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      samples[i] = sampleOf(cloud, static_cast<std::size_t>(members[i]));
  });
  return samples;
}

RawCloud
findRawPlanes(const PointView& points,
              const SensorView& sensors,
              double sigma,
              unsigned threads,
              const Progress& progress)
{
  RawCloud cloud{points, sensors, {}, {}, {}, 0, sigma};
  cloud.labels.assign(points.size(), -1);
  const NoiseScale scale = measureNoiseScale(points, sensors, threads);
  cloud.spacing = scale.spacing;
  if (!(scale.spacing > 0))
    return cloud;
  constexpr double sigmas = 4, spacings = 4; // of a cell
  const double noise = sigma > 0 ? sigma : scale.sigma;
  const double edge = std::max(sigmas * noise, spacings * scale.spacing);
  const CellCloud cells = cellsOf(sumVoxels(points, sensors, edge, threads));
  PlaneHypotheses hypotheses;
  hypotheses.points =
      PointView(cells.points.data(), sizeof(Eigen::Vector3f), cells.points.size());
  hypotheses.normals = cells.normals;
  PlaneClusteringSettings settings;
  settings.threads = threads;
  PlaneClusteringReport report;
  progress.tell(0.1, "planes");
  PlaneClusters clusters =
      clusterPlanes(hypotheses, {points, sensors}, settings, Progress(), report);
  cloud.planes = std::move(clusters.patches);
  cloud.labels = std::move(clusters.source_labels);
  constexpr double min_sagitta = 0.006; // walls are bowed
  markBentPlanes(min_sagitta, cloud);
  cloud.is_along_rays = isAlongRays(cloud);
  if (!(sigma > 0)) {
    const double measured = noiseOnPlanes(cloud);
    cloud.sigma = measured > 0 ? measured : scale.sigma;
  }
  return cloud;
}

} // namespace pcl::acmap::cylinders
