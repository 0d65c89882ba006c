#pragma once

#include "consolidation/thinning.h"

namespace pcl::acmap {

/** \brief For each cell the representative of its voxel and side, or the one that
 * displaced it. If its side has no representative, the first one of the voxel is used.
 */
PointLabels
representativesOfCells(const VoxelWindows& windows,
                       const LargeVector<Candidate>& candidates,
                       const Thinning& thinning);

/** \brief Sets the colour of each representative to the mean of the points that it
 * represents.
 * \param[in] of_cell from \ref representativesOfCells */
void
setMeanColors(const VoxelMoments& voxels,
              const PointLabels& of_cell,
              LargeVector<Representative>& representatives);

/** \brief For each point of a view its representative, -1 if there is none. This is a
 * second pass over the points. */
PointLabels
representativesOf(const PointView& points,
                  const SensorView& sensors,
                  const VoxelMoments& voxels,
                  const PointLabels& of_cell);

} // namespace pcl::acmap
