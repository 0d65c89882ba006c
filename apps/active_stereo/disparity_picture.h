#pragma once

#include <pcl/core/disparity_image.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Draws disparities as a grey picture, 8 bits per pixel: near is bright (64 to
 * 255), black (0) means invalid. The grey levels span the disparities without the
 * lowest and highest 1 %. */
std::vector<std::uint8_t>
pictureOf(const DisparityImage& disparities);

} // namespace pcl::acmap
