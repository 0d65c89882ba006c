#include <pcl/filters/consolidation_types.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

double
automaticVoxel(const NoiseScale& scale)
{
  constexpr double window_width = 5; // voxels
  // A slope between neighbours of 1/80 times the root of 2 is one degree.
  constexpr double residual_share = 1.0 / 80;
  const double by_noise =
      std::sqrt(scale.sigma * scale.sparse_spacing / (window_width * residual_share));
  // the windows have to hold the noise on both sides of the surface
  return std::max({by_noise, 2 * scale.sparse_spacing, 4 * scale.sigma});
}

bool
needsConsolidation(const NoiseScale& scale)
{
  constexpr double most_noise = 0.125; // of the spacing: faces ten degrees off
  return scale.sigma > most_noise * scale.spacing;
}

} // namespace pcl::acmap
