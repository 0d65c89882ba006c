#pragma once

#include "consolidation/noise_profile.h"

#include <pcl/core/voxel_windows.h>

#include <vector>

namespace pcl::acmap {

/** \brief A voxel's surface: the plane through its window, in edges from its centre. */
struct SurfaceFit {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< zero without a plane
  float thickness = 0;                              ///< edges
  float curvature = 0;
  float count = 0;       ///< points that it was fitted to
  PlaneNoise noise;      ///< of the window, whatever part of it was taken
  bool is_whole = false; ///< fitted to all of the window

  /** Octants of the cells that lie on it, a bit each. */
  std::uint8_t octants = 0xff;
};

/** \brief The surfaces of all voxels, most with one. */
struct SurfaceFits {
  std::vector<SurfaceFit> first; ///< one a voxel

  /** Voxels that are seen from both sides, ascending, with their second surface. */
  std::vector<std::pair<std::uint32_t, SurfaceFit>> second;

  std::size_t narrowed = 0;
};

/** \brief Fits each voxel's plane to the largest window about it that is still plane:
 * 5 x 5 x 5 voxels, else 3 x 3 x 3; where that is thicker than the noise, apart for the
 * sides that it was seen from, or the flattest 2 x 2 x 2 at a crease, or the voxel alone.
 */
SurfaceFits
fitSurfaces(const VoxelWindows& windows, NoiseProfile& noise);

} // namespace pcl::acmap
