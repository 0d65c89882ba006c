#pragma once

#include "light_pattern.h"
#include "lit_view.h"

#include <pcl/core/trinocular_frame.h>

#include <cstdint>

namespace pcl::acmap {

/** \brief Shades a view that was cast: light, blur, noise, conversion to 8 bits. Each
 * row has its own random stream. Runs in all threads of the caller's arena, with the
 * same result for any number of threads.
 * \param[in] view that was cast
 * \param[in] pattern on the projector, nullptr when it is off
 * \param[in] light and camera model
 * \param[in] stream seed of the noise of this image */
CameraImage
shadeShot(const LitView& view,
          const LightPattern* pattern,
          const SimulatedLight& light,
          std::uint64_t stream);

} // namespace pcl::acmap
