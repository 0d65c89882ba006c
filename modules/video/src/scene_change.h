#pragma once

#include <pcl/core/trinocular_frame.h>

namespace pcl::acmap {

/** \brief Measures how much the scene changed between two images of a camera: the
 * change of the mean, in grey levels, that at most 1 % of all blocks of 8 x 8 pixels
 * exceed. The mean of 64 pixels has an eighth of their noise.
 * \return infinity for images of different shapes */
double
sceneChange(const CameraImage& before, const CameraImage& after);

} // namespace pcl::acmap
