#pragma once

#include "consolidation/surface_fit.h"

#include <pcl/filters/consolidation_kernel.h>

namespace pcl::acmap {

/** \brief A representative before thinning. */
struct Candidate {
  Representative representative;
  std::uint32_t voxel;
  std::uint8_t octants;

  /** Edges that it was moved out of its own voxel; 0 when it stayed inside. */
  float strayed;
};

/** \brief Moves the mean of each voxel's points along the normal onto its surface.
 * \return ascending by voxel, the second side of a voxel after its first */
std::vector<Candidate>
makeCandidates(const VoxelWindows& windows,
               const SurfaceFits& fits,
               const SensorView& sensors);

} // namespace pcl::acmap
