#include "chain/surface_blocks.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

/** \brief Sums over points. Single precision would not be sufficient far from the
 * camera. */
struct PointSums {
  double count = 0, variance = 0; ///< variance: m^2, along the rays
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void
  add(const Eigen::Vector3d& point, double sigma)
  {
    count += 1;
    variance += sigma * sigma;
    first += point;
    second += point * point.transpose();
  }

  void
  add(const PointSums& other)
  {
    count += other.count;
    variance += other.variance;
    first += other.first;
    second += other.second;
  }
};

/** \brief Plane fitted to summed points. */
struct BlockPlane {
  Eigen::Vector3d center, normal;
  double roughness = 0; ///< RMS distance of the points, metres
  double slope = 0;     ///< |cosine| between the ray and the normal
  double flatness = 0;  ///< ratio of the second to the smallest variance
};

BlockPlane
planeThrough(const PointSums& sums)
{
  BlockPlane plane;
  plane.center = sums.first / sums.count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(sums.second / sums.count -
                       plane.center * plane.center.transpose());
  plane.normal = solver.eigenvectors().col(0);
  if (plane.normal.dot(plane.center) > 0)
    plane.normal = -plane.normal;
  const double minimum = std::max(solver.eigenvalues()[0], 0.0);
  plane.roughness = std::sqrt(minimum);
  plane.slope = -plane.normal.dot(plane.center.normalized());
  plane.flatness = solver.eigenvalues()[1] / std::max(minimum, 1e-12);
  return plane;
}

PointSums
sumsOfBlock(const CameraView& view, int column, int row)
{
  constexpr int size = SurfaceBlocks::size;
  PointSums sums;
  const int right = std::min((column + 1) * size, view.image.width);
  const int bottom = std::min((row + 1) * size, view.image.height);
  for (int y = row * size; y < bottom; ++y)
    for (int x = column * size; x < right; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * view.image.width + x;
      const Eigen::Vector3f& point = view.points[pixel];
      if (point.allFinite())
        sums.add(point.cast<double>(), view.sigmas.empty() ? 0 : view.sigmas[pixel]);
    }
  return sums;
}

/** \brief Sums of all blocks, row by row. */
struct BlockSums {
  int width = 0, height = 0;
  std::vector<PointSums> blocks;

  explicit BlockSums(const CameraView& view)
  : width((view.image.width + SurfaceBlocks::size - 1) / SurfaceBlocks::size)
  , height((view.image.height + SurfaceBlocks::size - 1) / SurfaceBlocks::size)
  , blocks(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
  {
    oneapi::tbb::parallel_for(0, height, [&](int row) {
      for (int column = 0; column < width; ++column)
        blocks[static_cast<std::size_t>(row * width + column)] =
            sumsOfBlock(view, column, row);
    });
  }

  /** \brief Sums of the block and its neighbours. */
  PointSums
  window(int column, int row) const
  {
    PointSums sums;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, height - 1); ++y)
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, width - 1); ++x)
        sums.add(blocks[static_cast<std::size_t>(y * width + x)]);
    return sums;
  }
};

constexpr double block_pixels = SurfaceBlocks::size * SurfaceBlocks::size;

/** \brief Returns true if there are enough points on all sides of a plane. */
bool
isFull(const PointSums& block, const PointSums& window)
{
  return block.count >= 0.5 * block_pixels && window.count >= 6 * block_pixels;
}

SurfaceBlock
surfaceBlock(const PointSums& block, const PointSums& window)
{
  constexpr double max_roughness = 2; // relative to that of noise alone
  SurfaceBlock surface;
  surface.normal.setZero();
  if (block.count == 0)
    return surface;
  surface.point = block.first / block.count;
  if (!isFull(block, window))
    return surface;
  const BlockPlane plane = planeThrough(window);
  const double variance = window.variance / window.count * plane.slope * plane.slope;
  if (plane.roughness > max_roughness * std::sqrt(variance) || plane.flatness < 10)
    return surface;
  surface.center = plane.center;
  surface.normal = plane.normal;
  surface.variance = variance;
  return surface;
}

} // namespace

SurfaceBlocks
surfaceBlocks(const CameraView& view)
{
  const BlockSums sums(view);
  SurfaceBlocks surfaces;
  surfaces.width = sums.width;
  surfaces.height = sums.height;
  surfaces.blocks.resize(sums.blocks.size());
  oneapi::tbb::parallel_for(0, sums.height, [&](int row) {
    for (int column = 0; column < sums.width; ++column) {
      const auto block = static_cast<std::size_t>(row * sums.width + column);
      surfaces.blocks[block] =
          surfaceBlock(sums.blocks[block], sums.window(column, row));
    }
  });
  return surfaces;
}

std::vector<float>
estimatedSigmas(const CameraView& view)
{
  constexpr double usual = 0.0025; // 1/m, if there are not enough planes
  const BlockSums sums(view);
  std::vector<double> growths;
  for (int row = 0; row < sums.height; ++row)
    for (int column = 0; column < sums.width; ++column) {
      const PointSums window = sums.window(column, row);
      if (!isFull(sums.blocks[static_cast<std::size_t>(row * sums.width + column)],
                  window))
        continue;
      const BlockPlane plane = planeThrough(window);
      if (plane.flatness > 30 && plane.slope > 0.3)
        growths.push_back(plane.roughness / plane.slope / plane.center.z() /
                          plane.center.z());
    }
  double growth = usual;
  if (growths.size() >= 20)
    growth = medianOf(growths);
  std::vector<float> sigmas;
  sigmas.reserve(view.points.size());
  for (const Eigen::Vector3f& point : view.points)
    sigmas.push_back(
        static_cast<float>(std::max(growth * point.z() * point.z(), 1e-4 * point.z())));
  return sigmas;
}

} // namespace pcl::acmap
