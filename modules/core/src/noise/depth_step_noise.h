#pragma once

#include <pcl/core/noise_scale.h>

namespace pcl::acmap {

/** Sets the noise of a view whose depth is quantised; does not change that of other
 * clouds.
 * \param[in] points metres, in the frame of the sensor
 * \param[in] width pixels per row, 0 if the points are not organized
 * \param[in,out] scale the noise of the cloud */
void
applyDepthSteps(const PointView& points, std::size_t width, NoiseScale& scale);

} // namespace pcl::acmap
