#pragma once

#include <pcl/core/noise_scale.h>
#include <pcl/core/voxel_moments.h>

namespace pcl::acmap {

/** \brief Noise along the ray by distance: how far points lie off the plane of their
 * window, over the cosine of the ray's incidence. */
std::vector<NoiseScale::Range>
measureRangeNoise(const PointView& points,
                  const SensorView& sensors,
                  const VoxelMoments& voxels);

} // namespace pcl::acmap
