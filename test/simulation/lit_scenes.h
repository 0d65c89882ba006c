#pragma once

#include "small_scenes.h"

#include <pcl/core/image_file.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/simulation/simulated_light.h>

#include <cstdint>

namespace pcl::acmap::test {

/** \brief Light without noise and blur, and a small projector at the standard pose. */
SimulatedLight
plainLight();

/** \brief A uniform pattern with the size of the projector. */
RgbImage
flatPattern(const SimulatedProjector& projector, std::uint8_t value);

/** \brief Smooth waves in both directions with periods of a few pixels, different in
 * each channel. */
RgbImage
wavePattern(const SimulatedProjector& projector);

/** \brief Value of a pixel's channel. */
int
valueAt(const CameraImage& image, int column, int row, int channel = 0);

} // namespace pcl::acmap::test
