#include <pcl/filters/consolidation_types.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

double
automaticVoxel(const NoiseScale& scale)
{
  constexpr double window_width = 5; // voxels
  // Noise of 1/80 of a voxel causes a slope of sqrt (2) / 80 between neighbours, which
  // is one degree.
  constexpr double residual_share = 1.0 / 80;
  const double by_noise =
      std::sqrt(scale.sigma * scale.sparse_spacing / (window_width * residual_share));
  // the windows must contain the noise on both sides of the surface
  return std::max({by_noise, 2 * scale.sparse_spacing, 4 * scale.sigma});
}

bool
needsConsolidation(const NoiseScale& scale)
{
  // relative to the spacing; the faces then deviate by ten degrees
  constexpr double max_noise = 0.125;
  return scale.sigma > max_noise * scale.spacing;
}

} // namespace pcl::acmap
