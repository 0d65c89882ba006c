#pragma once

#include <pcl/core/noise_scale.h>

namespace pcl::acmap {

/** Gives a view whose depth is quantised the noise of its steps; leaves others as they are.
 * \param[in] width pixels of a row, 0 where the points are not organized */
void
applyDepthSteps(const PointView& points, std::size_t width, NoiseScale& scale);

} // namespace pcl::acmap
