#pragma once

#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief What VoxelConsolidation tells about its last run. \ingroup filters */
struct ConsolidationReport : Report {
  std::size_t points = 0;         ///< of the input
  std::size_t invalid_points = 0; ///< not finite, skipped
  std::size_t distant_points = 0; ///< 2^19 voxels and more from the others, skipped
  std::size_t voxels = 0;         ///< occupied ones
  std::size_t representatives = 0;
  std::size_t two_sided_voxels = 0; ///< seen from both sides, with a point for each
  std::size_t narrowed_windows = 0; ///< at creases, fitted to the flattest 2 x 2 x 2
  std::size_t without_normal = 0;   ///< representatives with too few points around

  /** Whether the surfaces can have been seen from where the sensors are said to stand;
   * where not, the normals agree with their neighbours' instead. */
  bool sensors_fit = false;

  double voxel_size = 0; ///< metres; that was used
  double sigma = 0;      ///< metres; median noise of the input across its surface
  double residual = 0;   ///< metres; median noise of a representative, estimated
};

} // namespace pcl
