#include "outlines/crease_snap.h"
#include "outlines/face_loops.h"
#include "outlines/loop.h"
#include "outlines/patch_outlines.h"
#include "planes/known_planes.h"

#include <pcl/core/impl/depth_view.h>
#include <pcl/core/impl/moments.h>
#include <pcl/segmentation/impl/depth_plane_kernel.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace depth {
namespace {

/** \brief Returns the intersection of a ray of the view with a plane. */
Eigen::Vector3d
meet(const Eigen::Vector3d& ray, const Eigen::Vector4d& coefficients)
{
  // A ray half a pixel beyond the rim of a plane seen at a grazing angle may miss it.
  constexpr double farthest = 1000; // times the plane's distance
  const Eigen::Vector3d inverse = -coefficients.head<3>() / coefficients[3];
  return ray / std::max(inverse.dot(ray), inverse.norm() / farthest);
}

using Edges = std::vector<std::pair<std::int32_t, std::int32_t>>;

/** The corners of a view's pixels, y up, so that outer rims run counter-clockwise. */
class PixelCorners {
public:
  explicit PixelCorners(const DepthView& view)
  : view_(view)
  , columns_(view.width() + 1)
  {}

  /** For each plane the pixel edges that have its pixels on their left, sorted. */
  std::vector<Edges>
  rims(const PointLabels& labels, std::size_t planes) const
  {
    std::vector<Edges> rims(planes);
    const bool is_mirrored = view_.focal().x() * view_.focal().y() < 0;
    const auto add = [&](std::int32_t plane, std::size_t from, std::size_t to) {
      const auto a = static_cast<std::int32_t>(from);
      const auto b = static_cast<std::int32_t>(to);
      if (plane >= 0)
        rims[static_cast<std::size_t>(plane)].emplace_back(is_mirrored ? b : a,
                                                           is_mirrored ? a : b);
    };
    const std::size_t width = view_.width(), height = view_.height();
    const auto labelAt = [&](std::size_t row, std::size_t column) {
      return row < height && column < width ? labels[row * width + column] : -1;
    };
    // At row or column 0 the index of the neighbour wraps around, so that it is
    // outside.
    for (std::size_t row = 0; row <= height; ++row)
      for (std::size_t column = 0; column <= width; ++column) {
        const std::int32_t own = labelAt(row, column);
        const std::size_t corner = row * columns_ + column;
        const std::int32_t above = labelAt(row - 1, column);
        if (own != above) {
          add(own, corner + 1, corner);
          add(above, corner, corner + 1);
        }
        const std::int32_t before = labelAt(row, column - 1);
        if (own != before) {
          add(own, corner, corner + columns_);
          add(before, corner + columns_, corner);
        }
      }
    for (Edges& edges : rims)
      std::sort(edges.begin(), edges.end());
    return rims;
  }

  Eigen::Vector2d
  place(std::int32_t corner) const
  {
    const auto index = static_cast<std::size_t>(corner);
    return {std::copysign(static_cast<double>(index % columns_), view_.focal().x()),
            -std::copysign(static_cast<double>(index / columns_), view_.focal().y())};
  }

  /** Viewing ray through a position of the image, in pixels. */
  Eigen::Vector3d
  ray(const Eigen::Vector2d& place) const
  {
    return view_.ray(std::abs(place.x()) - 0.5, std::abs(place.y()) - 0.5);
  }

private:
  const DepthView& view_;
  std::size_t columns_;
};

std::vector<outlines::Loop>
loopsOf(const Edges& edges,
        const PixelCorners& corners,
        const outlines::PatchFrame& frame)
{
  constexpr double tolerance = 1.5, min_area = 25; // pixels, square pixels
  std::vector<outlines::Loop> loops;
  for (const std::vector<std::int32_t>& rim : outlines::edgeLoops(
           edges, [&](std::int32_t corner) { return corners.place(corner); })) {
    outlines::Loop in_picture;
    for (const std::int32_t corner : rim)
      in_picture.push_back(corners.place(corner));
    if (std::abs(outlines::signedArea(in_picture)) < min_area)
      continue;
    outlines::Loop loop;
    for (const Eigen::Vector2d& place :
         outlines::uncrossed(outlines::simplified(in_picture, tolerance)))
      loop.push_back(frame.flat(meet(corners.ray(place), frame.patch.coefficients)));
    if (loop.size() >= 3)
      loops.push_back(std::move(loop));
  }
  return loops;
}

/** \brief Sets the polygons of each plane and their area: the boundaries of its pixels
 * are simplified in the image and projected onto the plane. Gaps of a few pixels are
 * closed.
 * \param[in] labels for each pixel its plane, -1 for none */
void
outlinePixels(const DepthView& view,
              const PointLabels& labels,
              std::vector<KnownPlane>& planes)
{
  const PixelCorners corners(view);
  const std::vector<Edges> rims = corners.rims(labels, planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    PlanePatch& patch = planes[p].patch;
    const double footprint = patch.center.norm() / std::abs(view.focal().x());
    patch.area = 0;
    outlines::setPolygons(loopsOf(rims[p], corners, outlines::PatchFrame{patch}),
                          footprint * footprint,
                          footprint,
                          patch);
  }
}

/** Edge length of a noise cluster in pixels: noise is correlated within such a
 * square. */
constexpr std::size_t cluster_edge = 32;

/** Sums over the pixels of a plane. */
struct PatchSums {
  Moments points; ///< intersections of their rays with the plane
  Eigen::Matrix3d rays = Eigen::Matrix3d::Zero();    ///< sum of ray ray^T
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  ///< sum of cluster cluster^T
  Eigen::Vector3d cluster = Eigen::Vector3d::Zero(); ///< residual * ray in this one
  std::size_t clusters = 0;
  double squares = 0; ///< sum of squared distances from the plane, square metres

  void
  closeCluster()
  {
    if (cluster.isZero())
      return;
    spread += cluster * cluster.transpose();
    cluster.setZero();
    ++clusters;
  }
};

/** Visits the pixels of the planes cluster by cluster. */
std::vector<PatchSums>
sumPlanes(const DepthView& view, const DepthPlanes& found)
{
  std::vector<PatchSums> sums(found.planes.size());
  std::vector<double> scales; // 1/distances of the planes
  for (const DepthPlane& plane : found.planes)
    scales.push_back(plane.inverse.norm());
  for (std::size_t top = 0; top < view.height(); top += cluster_edge)
    for (std::size_t left = 0; left < view.width(); left += cluster_edge) {
      for (std::size_t row = top; row < std::min(top + cluster_edge, view.height());
           ++row)
        for (std::size_t column = left;
             column < std::min(left + cluster_edge, view.width());
             ++column) {
          const std::size_t pixel = row * view.width() + column;
          if (found.labels[pixel] < 0)
            continue;
          const auto p = static_cast<std::size_t>(found.labels[pixel]);
          const Eigen::Vector3d& inverse = found.planes[p].inverse;
          const Eigen::Vector3d ray = view.rayOf(column, row);
          const double measured = static_cast<double>(view.inverseDepth(pixel));
          const double of_plane = inverse.dot(ray);
          PatchSums& sum = sums[p];
          sum.points += momentsOf(ray / of_plane);
          sum.rays += ray * ray.transpose();
          sum.cluster += (measured - of_plane) * ray;
          const double off = (of_plane - measured) / (measured * scales[p]);
          sum.squares += off * off;
        }
      for (PatchSums& sum : sums)
        sum.closeCluster();
    }
  return sums;
}

/** Covariance of slopes and offset, estimated from the variation of the cluster
 * residuals.
 * \return NaN if there are too few clusters for an estimate */
Eigen::Matrix3d
covarianceOf(const PatchSums& sums, const DepthPlane& plane, const PlanePatch& patch)
{
  constexpr std::size_t fewest = 8;
  if (sums.clusters < fewest)
    return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  const Eigen::Matrix3d inverse = sums.rays.inverse();
  const double count = static_cast<double>(sums.clusters);
  const Eigen::Matrix3d of_plane =
      inverse * sums.spread * inverse * (count / (count - 3));
  // a point X of the plane moves by -X . d(a, b, c) / |(a, b, c)| along the normal
  Eigen::Matrix3d moved;
  moved << patch.axis_u.transpose(), patch.axis_v.transpose(), patch.center.transpose();
  moved /= plane.inverse.norm();
  const Eigen::Matrix3d covariance = moved * of_plane * moved.transpose();
  return (covariance + covariance.transpose()) / 2;
}

PlanePatch
patchOf(const DepthPlane& plane, const PatchSums& sums)
{
  PlanePatch patch;
  const Eigen::Vector3d normal = -plane.normal(); // towards the sensor
  patch.coefficients << normal, plane.distance();
  const PlaneFit spread = fitPlane(sums.points);
  patch.center = spread.mean;
  const Eigen::Vector3d along =
      spread.long_axis - spread.long_axis.dot(normal) * normal;
  patch.axis_u = along.norm() > 0.5 ? along.normalized() : normal.unitOrthogonal();
  patch.axis_v = normal.cross(patch.axis_u);
  patch.support = plane.pixels;
  patch.rms = std::sqrt(sums.squares / static_cast<double>(plane.pixels));
  patch.covariance = covarianceOf(sums, plane, patch);
  patch.effective_support = std::min(patch.rms * patch.rms / patch.covariance(2, 2),
                                     static_cast<double>(plane.pixels));
  if (std::isnan(patch.covariance(2, 2)))
    patch.effective_support = patch.covariance(2, 2);
  return patch;
}

void
describe(const DepthView& view, const DepthPlanes& found, DepthPlaneReport& report)
{
  report.points = view.size();
  report.invalid_points = view.size() - view.measured();
  report.planes = found.planes.size();
  for (const DepthPlane& plane : found.planes)
    report.points_on_planes += plane.pixels;
  report.small_regions = found.small;
  report.curved_regions = found.curved;
  report.merged = found.merged;
  if (found.planes.empty())
    report.remarks.push_back("no planes: " + std::to_string(found.small) +
                             " regions of the view are too small or of unknown tilt, " +
                             std::to_string(found.curved) +
                             " are strips of curved surfaces");
}

} // namespace
} // namespace depth

PlaneClusters
segmentDepthPlanes(const DepthView& view,
                   const NoiseScale::InverseDepth& noise,
                   const DepthSegmentationSettings& settings,
                   const Progress& progress,
                   DepthPlaneReport& report)
{
  using namespace depth;
  report = {};
  report.noise = noise;
  StepTimer timer(report);
  DepthPlaneSettings finding;
  finding.noise = noise;
  finding.min_area = settings.min_area;
  DepthPlanes found = findDepthPlanes(view, finding, progress);
  timer.finish("planes");
  const std::vector<PatchSums> sums = sumPlanes(view, found);
  std::vector<KnownPlane> planes;
  for (std::size_t p = 0; p < sums.size(); ++p)
    planes.push_back({patchOf(found.planes[p], sums[p])});
  if (settings.regular) {
    const planes::Regularity regularity = planes::makeRegular(planes);
    report.regular_planes = regularity.turned;
    report.largest_turn = regularity.largest_turn;
  }
  timer.finish("fits");
  outlinePixels(view, found.labels, planes);
  timer.finish("outlines");
  describe(view, found, report);
  PlaneClusters clusters;
  clusters.labels = std::move(found.labels);
  for (KnownPlane& plane : planes)
    clusters.patches.push_back(std::move(plane.patch));
  planes::sortByArea(clusters);
  return clusters;
}

} // namespace pcl::acmap
