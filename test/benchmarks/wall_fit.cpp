#include "wall_fit.h"

#include "disparity_point.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace pcl::acmap::bench {

namespace {

using Point = Eigen::Vector3d;

struct FittedWall {
  Point middle = Point::Zero();
  Point normal = Point::UnitZ(); // pointing away from the camera
};

FittedWall
fitPlane(const std::vector<Point>& points)
{
  FittedWall plane;
  for (const Point& point : points)
    plane.middle += point / static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Point& point : points)
    scatter += (point - plane.middle) * (point - plane.middle).transpose();
  plane.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter)
                     .eigenvectors()
                     .col(0)
                     .normalized();
  if (plane.normal.z() < 0)
    plane.normal = -plane.normal;
  return plane;
}

/** The pixels of the wall with a correct disparity. */
std::vector<std::size_t>
wallPixels(const MatchedDisparity& found,
           const SimulatedTruth& truth,
           const PixelMask& mask)
{
  constexpr float bad = 1.0f; // px
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i] != 0 && truth.surfaces[i] == 0 &&
        std::abs(found.disparity.values[i] - truth.horizontal.values[i]) <= bad)
      pixels.push_back(i);
  return pixels;
}

} // namespace

WallFit
fitWall(const MatchedDisparity& found,
        const SimulatedTruth& truth,
        const PixelMask& mask,
        const TrinocularRig& rig)
{
  const std::vector<std::size_t> pixels = wallPixels(found, truth, mask);
  std::vector<Point> points, exact;
  for (const std::size_t pixel : pixels) {
    points.push_back(pointOf(rig, pixel, found.disparity.values[pixel]));
    exact.push_back(pointOf(rig, pixel, truth.horizontal.values[pixel]));
  }
  const FittedWall plane = fitPlane(points);
  const FittedWall true_plane = fitPlane(exact);
  WallFit fit;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double off = plane.normal.dot(points[i] - plane.middle);
    // A disparity error moves its point along the ray.
    const double step = plane.normal.dot(points[i]) * found.sigma[pixels[i]] /
                        found.disparity.values[pixels[i]];
    fit.rms += off * off;
    fit.expected += step * step;
  }
  const auto count = static_cast<double>(pixels.size());
  fit.rms = std::sqrt(fit.rms / count);
  fit.expected = std::sqrt(fit.expected / count);
  fit.offset = true_plane.normal.dot(plane.middle - true_plane.middle);
  fit.turn = std::asin(plane.normal.cross(true_plane.normal).norm());
  return fit;
}

WallFit
meanOf(const std::vector<WallFit>& fits)
{
  WallFit mean;
  const auto count = static_cast<double>(fits.size());
  for (const WallFit& fit : fits) {
    mean.rms += fit.rms / count;
    mean.expected += fit.expected / count;
    mean.offset += fit.offset / count;
    mean.turn += fit.turn / count;
  }
  return mean;
}

} // namespace pcl::acmap::bench
