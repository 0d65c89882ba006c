#include "consolidation/automatic_voxel.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double window_width = 5; // voxels

} // namespace

double
residualNoise(double sigma, double spacing, double voxel_size)
{
  const double points = std::max(1.0, std::pow(window_width * voxel_size / spacing, 2));
  return sigma / std::sqrt(points);
}

double
automaticVoxel(const NoiseScale& scale)
{
  // A slope between neighbours of 1/80 times the root of 2 is one degree.
  constexpr double residual_share = 1.0 / 80;
  const double by_noise =
      std::sqrt(scale.sigma * scale.sparse_spacing / (window_width * residual_share));
  // the windows have to hold the noise on both sides of the surface
  return std::max({by_noise, 2 * scale.sparse_spacing, 4 * scale.sigma});
}

} // namespace pcl::acmap
