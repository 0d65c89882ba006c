#pragma once

#include <pcl/core/disparity_image.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A grey picture of disparities, 8 bits a pixel: near is bright (64 to 255), black
 * (0) has none. The greys span what was found, but for a hundredth at each end. */
std::vector<std::uint8_t>
pictureOf(const DisparityImage& disparities);

} // namespace pcl::acmap
