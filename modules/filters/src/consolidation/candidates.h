#pragma once

#include "consolidation/surface_fit.h"

#include <pcl/filters/impl/consolidation_kernel.h>

namespace pcl::acmap {

/** \brief A representative before thinning. */
struct Candidate {
  Representative representative;
  std::uint32_t voxel;
  std::uint8_t octants;

  /** Distance in edges by which it was moved along the normal, if it left its voxel; 0
   * if it is inside. */
  float strayed;
};

/** \brief Moves the mean of the points of each voxel along the normal onto its surface.
 * \return in ascending order of voxels, the second side of a voxel after its first one
 */
LargeVector<Candidate>
makeCandidates(const VoxelWindows& windows,
               const SurfaceFits& fits,
               const SensorView& sensors);

} // namespace pcl::acmap
