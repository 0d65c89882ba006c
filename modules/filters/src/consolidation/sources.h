#pragma once

#include "consolidation/thinning.h"

namespace pcl::acmap {

/** \brief For each cell the representative of its voxel and side, or of who displaced it:
 * the voxel's first one where its side has none. */
std::vector<std::int32_t>
representativesOfCells(const VoxelWindows& windows,
                       const std::vector<Candidate>& candidates,
                       const Thinning& thinning);

/** \brief Gives each representative the mean colour of the points that it stands for.
 * \param[in] of_cell from \ref representativesOfCells */
void
setMeanColors(const VoxelMoments& voxels,
              const std::vector<std::int32_t>& of_cell,
              std::vector<Representative>& representatives);

/** \brief For each point of a view its representative, -1 for those that have none. Reads
 * the points once more. */
std::vector<std::int32_t>
representativesOf(const PointView& points,
                  const SensorView& sensors,
                  const VoxelMoments& voxels,
                  const std::vector<std::int32_t>& of_cell);

} // namespace pcl::acmap
