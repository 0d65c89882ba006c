#pragma once

#include <pcl/core/export.h>
#include <pcl/core/noise_scale.h>
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

/** \brief Maximum edge length of a mesh of consolidated points, in voxels: it bridges the
 * jitter of the representatives. \ingroup filters */
inline constexpr double mesh_edge_in_voxels = 2.5;

namespace acmap {

/** \brief Computes the voxel size for a cloud: the smallest one whose representatives keep
 * at most 1/80 of it as noise, at least twice the spacing where points are sparse and at
 * least four times the noise.
 * \return metres; 0 if the scale has no spacing */
ACMAP_EXPORT double
automaticVoxel(const NoiseScale& scale);

/** \brief Is the noise so large compared with the spacing that a mesh through the points
 * would be crumpled? Other clouds are better meshed as they are: sparse regions keep their
 * detail. */
ACMAP_EXPORT bool
needsConsolidation(const NoiseScale& scale);

} // namespace acmap
} // namespace pcl
