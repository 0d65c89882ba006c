#pragma once

#include "small_scenes.h"

#include <pcl/core/image_file.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/simulation/simulated_light.h>

#include <cstdint>

namespace pcl::acmap::test {

/** \brief Light without noise or blur, and a small projector at the standard place. */
SimulatedLight
plainLight();

/** \brief A pattern of one colour, of the projector's size. */
RgbImage
flatPattern(const SimulatedProjector& projector, std::uint8_t value);

/** \brief Waves along both directions, a few pixels long: smooth, with each channel its
 * own. */
RgbImage
wavePattern(const SimulatedProjector& projector);

/** \brief Value of a pixel's channel. */
int
valueAt(const CameraImage& image, int column, int row, int channel = 0);

} // namespace pcl::acmap::test
