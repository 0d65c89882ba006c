#include "labeling/stragglers.h"

#include <cmath>

namespace pcl::acmap::labeling {

void
gatherStragglers(double distance, const CandidateGrid& grid, KnownPlanes& known)
{
  for (std::size_t i = 0; i < known.labels.size(); ++i) {
    VoxelHit hit;
    const Eigen::Vector3f point = known.points[i];
    if (known.labels[i] >= 0 || !grid.lattice().locate(point, hit))
      continue;
    const std::int32_t entry = grid.find(voxelKey(hit.place));
    double least = distance;
    for (std::size_t k = 0; entry >= 0 && k < grid[entry].size; ++k) {
      const std::int32_t plane = grid[entry].planes[k];
      const Eigen::Vector4d& its =
          known.planes[static_cast<std::size_t>(plane)].patch.coefficients;
      const double off = std::abs(its.head<3>().dot(point.cast<double>()) + its[3]);
      if (off < least) {
        least = off;
        known.labels[i] = plane;
      }
    }
  }
}

} // namespace pcl::acmap::labeling
