#pragma once

#include <pcl/core/noise_scale.h>

namespace pcl::acmap {

/** \brief Noise that is left in a representative: the window of 25 faces averages it.
 * \param[in] voxel_size metres
 * \return metres */
double
residualNoise(double sigma, double spacing, double voxel_size);

/** \brief The smallest voxel whose representatives keep at most 1/80 of it as noise and
 * that is twice as large as the spacing where points are sparse, and four times as large
 * as the noise; metres. */
double
automaticVoxel(const NoiseScale& scale);

} // namespace pcl::acmap
