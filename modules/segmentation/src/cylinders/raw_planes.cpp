#include "cylinders/raw_cylinders.h"

#include "median.h"

#include <pcl/core/impl/voxel_windows.h>
#include <pcl/core/noise_scale.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::cylinders {
namespace {

/** One point and normal for each cell of a cloud. */
struct CellCloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals; ///< towards the sensors; NaN where not planar
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
    for (std::size_t c = windows.firstCell(voxel); c < windows.firstCell(voxel + 1); ++c)
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

/** Noise along the rays, from the points on planes; without sensors across these. */
double
noiseOnPlanes(const RawCloud& cloud)
{
  constexpr double min_cosine = 0.3;
  std::vector<double> offs;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (cloud.labels[i] < 0)
      continue;
    const Eigen::Vector4d& plane =
        cloud.planes[static_cast<std::size_t>(cloud.labels[i])].coefficients;
    const Eigen::Vector3f point = cloud.points[i];
    const Eigen::Vector3f* const sensor = cloud.sensors[i];
    const double off = plane.head<3>().dot(point.cast<double>()) + plane[3];
    double cosine = 1;
    if (sensor)
      cosine = std::abs(
          plane.head<3>().dot((point - *sensor).cast<double>().normalized()));
    if (cosine > min_cosine)
      offs.push_back(std::abs(off) / cosine);
  }
  constexpr std::size_t min_points = 100;
  constexpr double median_of_normal = 0.6745;
  return offs.size() < min_points ? 0 : medianOf(offs) / median_of_normal;
}

} // namespace

RawCloud
findRawPlanes(const PointView& points,
              const SensorView& sensors,
              double sigma,
              unsigned threads,
              const Progress& progress)
{
  RawCloud cloud{points, sensors, {}, {}, 0, sigma};
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
  hypotheses.points = PointView(
      cells.points.data(), sizeof(Eigen::Vector3f), cells.points.size());
  hypotheses.normals = cells.normals;
  PlaneClusteringSettings settings;
  settings.threads = threads;
  PlaneClusteringReport report;
  progress.tell(0.1, "planes");
  PlaneClusters clusters =
      clusterPlanes(hypotheses, {points, sensors}, settings, Progress(), report);
  cloud.planes = std::move(clusters.patches);
  cloud.labels = std::move(clusters.source_labels);
  if (!(sigma > 0)) {
    const double measured = noiseOnPlanes(cloud);
    cloud.sigma = measured > 0 ? measured : scale.sigma;
  }
  return cloud;
}

} // namespace pcl::acmap::cylinders
