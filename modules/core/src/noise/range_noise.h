#pragma once

#include <pcl/core/noise_scale.h>
#include <pcl/core/voxel_moments.h>

namespace pcl::acmap {

/** \brief Noise along the ray in bins of distance: the distances of the points to the
 * plane of their window, divided by the cosine of the angle of incidence. */
std::vector<NoiseScale::Range>
measureRangeNoise(const PointView& points,
                  const SensorView& sensors,
                  const VoxelMoments& voxels);

} // namespace pcl::acmap
