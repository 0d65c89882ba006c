#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/export.h>

#include <cstdint>
#include <vector>

namespace pcl {

/** \brief Draws disparities as a grey picture, 8 bits per pixel: near is bright (64 to 255),
 * black (0) means invalid. The grey levels span the disparities without the lowest and highest
 * 1 %.
 * \return row by row, with the size of the image \ingroup pipeline */
ACMAP_EXPORT std::vector<std::uint8_t>
disparityPicture(const DisparityImage& disparities);

} // namespace pcl
