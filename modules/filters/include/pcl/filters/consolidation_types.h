#pragma once

#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief Report of the last run of VoxelConsolidation. \ingroup filters */
struct ConsolidationReport : Report {
  std::size_t points = 0;         ///< of the input
  std::size_t invalid_points = 0; ///< not finite, skipped
  /** \brief Points at least 2^19 voxels away from the others, which were skipped. */
  std::size_t distant_points = 0;
  std::size_t voxels = 0; ///< number of occupied voxels
  std::size_t representatives = 0;
  std::size_t two_sided_voxels = 0; ///< seen from both sides, with one point per side
  /** \brief Voxels at creases, fitted to the flattest 2 x 2 x 2 voxels. */
  std::size_t narrowed_windows = 0;
  std::size_t without_normal = 0; ///< representatives with too few points around them

  /** Are the sensor positions consistent with the surfaces? If not, the normals are
   * made consistent with those of their neighbours instead. */
  bool sensors_fit = false;

  double voxel_size = 0; ///< metres; as used
  double sigma = 0;      ///< metres; median noise of the input across its surface
  double residual = 0;   ///< metres; estimated median noise of a representative
};

} // namespace pcl
