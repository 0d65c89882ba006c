#pragma once

#include <pcl/egomotion/keypoint_kernel.h>

namespace pcl::acmap {

/** \brief The image under a Gaussian, its rims continued by their last pixels.
 * \param[in] sigma pixels, above 0; cut off at three of them */
GreyImage
smoothedImage(const GreyImage& image, float sigma);

} // namespace pcl::acmap
