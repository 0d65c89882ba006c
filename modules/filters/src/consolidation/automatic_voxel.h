#pragma once

#include <pcl/core/noise_scale.h>

namespace pcl::acmap {

/** \brief The smallest voxel whose representatives keep at most 1/80 of it as noise and
 * that is twice as large as the spacing where points are sparse, and four times as large
 * as the noise; metres. */
double
automaticVoxel(const NoiseScale& scale);

} // namespace pcl::acmap
