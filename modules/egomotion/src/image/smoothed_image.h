#pragma once

#include <pcl/egomotion/impl/keypoint_kernel.h>

namespace pcl::acmap {

/** \brief Smooths the image with a Gaussian; the outermost pixels are repeated outside.
 * \param[in] sigma pixels, above 0; the Gaussian is cut off at 3 sigma */
GreyImage
smoothedImage(const GreyImage& image, float sigma);

} // namespace pcl::acmap
