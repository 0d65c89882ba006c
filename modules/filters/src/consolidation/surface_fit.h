#pragma once

#include "consolidation/noise_profile.h"

#include <pcl/core/impl/voxel_windows.h>
#include <pcl/core/progress.h>

#include <vector>

namespace pcl::acmap {

/** \brief The surface of a voxel: the plane of its window, in edges relative to its
 * centre. */
struct SurfaceFit {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< zero without a plane
  float thickness = 0;                              ///< edges
  float curvature = 0;
  float count = 0;       ///< number of points to which it was fitted
  PlaneNoise noise;      ///< of the whole window, even if a part was fitted
  bool is_whole = false; ///< fitted to the whole window

  /** Octants of the cells that are on it, one bit each. */
  std::uint8_t octants = 0xff;
};

/** \brief The surfaces of all voxels; most voxels have one. */
struct SurfaceFits {
  LargeVector<SurfaceFit> first; ///< one per voxel

  /** Second surface of the voxels that were seen from both sides, in ascending order of
   * voxels. */
  LargeVector<std::pair<std::uint32_t, SurfaceFit>> second;

  std::size_t narrowed = 0;
};

/** \brief Fits the plane of each voxel to the largest window around it that is still
 * planar: 5 x 5 x 5 voxels, otherwise 3 x 3 x 3. If it is thicker than the noise, fits
 * separate planes to the sides from which it was seen, or the flattest 2 x 2 x 2 voxels
 * at a crease, or the voxel alone. */
SurfaceFits
fitSurfaces(const VoxelWindows& windows, const Progress& progress, NoiseProfile& noise);

} // namespace pcl::acmap
